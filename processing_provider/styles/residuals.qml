<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>
<!-- made by Ichnograph -->
<qgis styleCategories="Symbology|Labeling" version="3.22" labelsEnabled="1">
  <renderer-v2 type="RuleRenderer" enableorderby="0" symbollevels="0" forceraster="0">
    <rules key="{rules}">
      <rule label="Residual, $exaggeration times: horizontal blue, height orange" filter="&quot;used&quot; = 1" key="{used}" symbol="0"/>
      <rule label="Rejected target" filter="&quot;used&quot; = 0" key="{rejected}" symbol="1"/>
    </rules>
    <symbols>
      <symbol type="marker" name="0" alpha="1" clip_to_extent="1" force_rhr="0">
        <layer class="VectorField" enabled="1" locked="0" pass="0">
          <Option type="Map">
            <Option type="QString" name="x_attribute" value="vx"/>
            <Option type="QString" name="y_attribute" value="vy"/>
            <Option type="QString" name="vector_field_type" value="0"/>
            <Option type="QString" name="scale" value="$exaggeration"/>
            <Option type="QString" name="distance_unit" value="RenderMetersInMapUnits"/>
            <Option type="QString" name="angle_orientation" value="0"/>
            <Option type="QString" name="angle_units" value="0"/>
          </Option>
          <symbol type="line" name="@0@0" alpha="1" clip_to_extent="1" force_rhr="0">
            <layer class="ArrowLine" enabled="1" locked="0" pass="0">
              <Option type="Map">
                <Option type="QString" name="arrow_start_width" value="0.4"/>
                <Option type="QString" name="arrow_start_width_unit" value="MM"/>
                <Option type="QString" name="arrow_width" value="0.4"/>
                <Option type="QString" name="arrow_width_unit" value="MM"/>
                <Option type="QString" name="head_length" value="1.6"/>
                <Option type="QString" name="head_length_unit" value="MM"/>
                <Option type="QString" name="head_thickness" value="0.9"/>
                <Option type="QString" name="head_thickness_unit" value="MM"/>
                <Option type="QString" name="arrow_type" value="0"/>
                <Option type="QString" name="head_type" value="0"/>
                <Option type="QString" name="is_curved" value="0"/>
                <Option type="QString" name="is_repeated" value="0"/>
              </Option>
            <symbol type="fill" name="@@0@0@0" alpha="1" clip_to_extent="1" force_rhr="0">
              <layer class="SimpleFill" enabled="1" locked="0" pass="0">
                <Option type="Map">
                  <Option type="QString" name="color" value="59,120,168,255"/>
                  <Option type="QString" name="style" value="solid"/>
                  <Option type="QString" name="outline_style" value="no"/>
                </Option>
                <!-- A legend has no feature; arrows there would be as long as QGIS has room, and push the words out. -->
                <data_defined_properties>
                  <Option type="Map">
                    <Option type="Map" name="properties">
                      <Option type="Map" name="enabled">
                        <Option type="bool" name="active" value="true"/>
                        <Option type="QString" name="expression" value="try(&quot;used&quot; = 1, false)"/>
                        <Option type="int" name="type" value="3"/>
                      </Option>
                    </Option>
                  </Option>
                </data_defined_properties>
              </layer>
            </symbol>
            </layer>
          </symbol>
        </layer>
        <layer class="VectorField" enabled="1" locked="0" pass="0">
          <Option type="Map">
            <Option type="QString" name="x_attribute" value=""/>
            <Option type="QString" name="y_attribute" value="vz"/>
            <Option type="QString" name="vector_field_type" value="2"/>
            <Option type="QString" name="scale" value="$exaggeration"/>
            <Option type="QString" name="distance_unit" value="RenderMetersInMapUnits"/>
            <Option type="QString" name="angle_orientation" value="0"/>
            <Option type="QString" name="angle_units" value="0"/>
          </Option>
          <symbol type="line" name="@0@1" alpha="1" clip_to_extent="1" force_rhr="0">
            <layer class="ArrowLine" enabled="1" locked="0" pass="0">
              <Option type="Map">
                <Option type="QString" name="arrow_start_width" value="0.4"/>
                <Option type="QString" name="arrow_start_width_unit" value="MM"/>
                <Option type="QString" name="arrow_width" value="0.4"/>
                <Option type="QString" name="arrow_width_unit" value="MM"/>
                <Option type="QString" name="head_length" value="1.6"/>
                <Option type="QString" name="head_length_unit" value="MM"/>
                <Option type="QString" name="head_thickness" value="0.9"/>
                <Option type="QString" name="head_thickness_unit" value="MM"/>
                <Option type="QString" name="arrow_type" value="0"/>
                <Option type="QString" name="head_type" value="0"/>
                <Option type="QString" name="is_curved" value="0"/>
                <Option type="QString" name="is_repeated" value="0"/>
              </Option>
            <symbol type="fill" name="@@0@1@0" alpha="1" clip_to_extent="1" force_rhr="0">
              <layer class="SimpleFill" enabled="1" locked="0" pass="0">
                <Option type="Map">
                  <Option type="QString" name="color" value="224,160,48,255"/>
                  <Option type="QString" name="style" value="solid"/>
                  <Option type="QString" name="outline_style" value="no"/>
                </Option>
                <data_defined_properties>
                  <Option type="Map">
                    <Option type="Map" name="properties">
                      <Option type="Map" name="enabled">
                        <Option type="bool" name="active" value="true"/>
                        <Option type="QString" name="expression" value="try(&quot;used&quot; = 1, false)"/>
                        <Option type="int" name="type" value="3"/>
                      </Option>
                    </Option>
                  </Option>
                </data_defined_properties>
              </layer>
            </symbol>
            </layer>
          </symbol>
        </layer>
        <layer class="SimpleMarker" enabled="1" locked="0" pass="0">
          <Option type="Map">
            <Option type="QString" name="name" value="circle"/>
            <Option type="QString" name="size" value="1.6"/>
            <Option type="QString" name="size_unit" value="MM"/>
            <Option type="QString" name="color" value="55,71,79,255"/>
            <Option type="QString" name="outline_style" value="no"/>
          </Option>
        </layer>
      </symbol>
      <symbol type="marker" name="1" alpha="1" clip_to_extent="1" force_rhr="0">
        <layer class="SimpleMarker" enabled="1" locked="0" pass="0">
          <Option type="Map">
            <Option type="QString" name="name" value="cross2"/>
            <Option type="QString" name="size" value="3"/>
            <Option type="QString" name="size_unit" value="MM"/>
            <Option type="QString" name="color" value="179,38,30,255"/>
            <Option type="QString" name="outline_color" value="179,38,30,255"/>
            <Option type="QString" name="outline_style" value="solid"/>
            <Option type="QString" name="outline_width" value="0.6"/>
            <Option type="QString" name="outline_width_unit" value="MM"/>
          </Option>
        </layer>
      </symbol>
    </symbols>
  </renderer-v2>
  <labeling type="simple">
    <settings calloutType="simple">
      <text-style fieldName="&quot;target&quot; || ' → ' || &quot;control&quot; || '\n' || format_number(1000 * &quot;v&quot;, 1) || ' mm'" isExpression="1" fontSize="7" fontSizeUnit="Point" fontWeight="50" textColor="55,71,79,255" textOpacity="1" multilineHeight="0.9">
        <text-buffer bufferDraw="1" bufferSize="0.6" bufferSizeUnits="MM" bufferColor="255,255,255,255" bufferOpacity="0.8" bufferNoFill="1"/>
      </text-style>
      <placement placement="6" predefinedPositionOrder="TR,TL,BR,BL,R,L,TSR,BSR" dist="1.2" distUnits="MM" offsetType="1"/>
      <rendering drawLabels="1" obstacle="1" obstacleType="1"/>
      <dd_properties>
        <Option type="Map">
          <Option type="QString" name="name" value=""/>
          <Option type="Map" name="properties">
            <Option type="Map" name="Color">
              <Option type="bool" name="active" value="true"/>
              <Option type="QString" name="expression" value="if(&quot;used&quot; = 1, '#37474f', '#b3261e')"/>
              <Option type="int" name="type" value="3"/>
            </Option>
          </Option>
          <Option type="QString" name="type" value="collection"/>
        </Option>
      </dd_properties>
    </settings>
  </labeling>
</qgis>
