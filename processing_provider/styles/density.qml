<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>
<!-- made by Ichnograph -->
<qgis styleCategories="Symbology" version="3.22">
  <pipe>
    <rasterrenderer type="singlebandgray" grayBand="1" gradient="WhiteToBlack" alphaBand="-1" nodataColor="" opacity="1">
      <minMaxOrigin>
        <limits>StdDev</limits>
        <extent>WholeRaster</extent>
        <statAccuracy>Exact</statAccuracy>
        <stdDevFactor>2</stdDevFactor>
      </minMaxOrigin>
      <contrastEnhancement>
        <minValue>$minimum</minValue>
        <maxValue>$maximum</maxValue>
        <algorithm>StretchToMinimumMaximum</algorithm>
      </contrastEnhancement>
    </rasterrenderer>
  </pipe>
  <blendMode>0</blendMode>
</qgis>
