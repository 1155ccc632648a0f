<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>
<!-- made by Ichnograph -->
<qgis styleCategories="Symbology" version="3.22">
  <pipe>
    <rasterrenderer type="paletted" band="1" alphaBand="-1" nodataColor="" opacity="1">
      <colorPalette>
        <paletteEntry value="0" color="#ffffff" alpha="0" label="open"/>
        <paletteEntry value="1" color="#33291f" alpha="255" label="wall"/>
      </colorPalette>
    </rasterrenderer>
  </pipe>
  <blendMode>0</blendMode>
</qgis>
