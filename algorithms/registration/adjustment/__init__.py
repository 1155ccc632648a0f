"""The least squares adjustment and its statistics."""
