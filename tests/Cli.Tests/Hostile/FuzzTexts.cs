using Harvester.Cli.Tests.Repetition;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>The input files of a corpus that no command writes.</summary>
internal static class FuzzTexts
{
    /// <summary>Paint on the first link of straight.csv.</summary>
    private const string Paint =
        "harvester paint,1\nlink,0,0,-200,30,0,0,30,0,200\nline,0,0,100,0,0,doubleSolid,yellow,0.4,,,,0.02,3\n"
        + "line,0,0,100,4.1,4.1,dashed,white,0.15,3,9,1.5,0.02,2\n"
        + "mark,stopLine,0.05,4,0.3,-10,30,4.8,-10,30,4.8,-9.5,30,0.3,-9.5,30\nend,1,2,1\n";

    /// <summary>Events of road users that are in no label.</summary>
    public static string Events { get; } =
        string.Concat(
            Event(1, "hardBraking", Participant("null", "null"), "\"deceleration\":6,\"speedBefore\":8,\"speedAfter\":5"),
            Event(2, "offRoad", Participant("1000", "\"truck\""), "\"fromRoad\":3.5,\"speed\":5"),
            Event(
                3,
                "cutIn",
                Participant("1001", "\"car\"") + "," + Participant("null", "null"),
                "\"gap\":5,\"timeGapSeconds\":1,\"closingSpeed\":-0.5"
            )
        );

    private static readonly (string Name, string Content)[] All =
    [
        ("survey/spaces.csv", "prop_sign_road_01a,-949234773,sign,STOP,R1-1,0,-0.5,-0.04,3,0.5,-0.06,1.5,-y,measured,a test\n"),
        ("survey/photos.csv", "file,model,x,y,z,pitch,roll,yaw,verticalFov\na.png,prop_sign_road_01a,0,-3,2,0,0,0,50\n"),
        ("points.csv", "0,5,0\n1.5,20,-3\n"),
        ("vehicles.csv", "10,20,0,90\n-5,3,0,0,12\n"),
        ("straight.csv", WritingCommand.Roads),
        ("paint.csv", Paint),
        ("places.csv", "# places\nname,x,y\nNorth end,0,150.5\nSouth end,-1,-150\n"),
        (
            "props.json",
            """
            [{"Name": "prop_traffic_01a", "Position": {"X": 5.5, "Y": 20, "Z": 30}, "Rotation": {"X": 0, "Y": 0, "Z": 90}},
             {"Name": "prop_streetlight_01", "Position": {"X": -6, "Y": 40, "Z": 30}, "Rotation": {"X": 0, "Y": 0, "Z": -90}}]
            """
        ),
        ("lens.txt", "FocalScale = 1.1\nCentreOffsetX = 0.01\nCentreOffsetY = 0\nK1 = 0.05\nK2 = 0\n"),
        (
            "boxes.json",
            """
            {"camera": {"position": [0, 0, 0], "rotation": [0, 0, 0], "verticalFovDegrees": 50, "width": 80, "height": 60},
             "cuboids": [{"name": "a", "centre": [0, 10, 0], "halfExtents": [1, 2, 1], "rotation": [0, 0, 30]}]}
            """
        ),
        (
            "selftest.json",
            """
            {"formatVersion":1,"kind":"selfTest","tool":"GtaDataHarvester 1.0","game":"GTA V","isComplete":true,"checks":[
            {"check":"window","verdict":"good","finding":"Pictures show the game's window."},
            {"check":"hud","verdict":"problem","finding":"The game's display stays in the picture."}],
            "changedSettings":{"Freeze":"TimeScale"},"pictures":["colours.png"]}
            """
        ),
        (
            "GtaDataHarvester.log",
            "2026-01-01 10:00:00 GtaDataHarvester 1.0.0, API v3.6.0, game 1.0.3095.0\n" + "2026-01-01 10:00:01 Harvest started.\n"
        ),
        (
            "paths.ipl",
            """
            version
            end
            vnod
            0, -200, 30, 0, 0, 0, 1, 0, 0.5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0
            0, 0, 30, 0, 0, 0, 2, 15, 1, 305419896, 1, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0
            end
            link
            0, 1, -1, 2, 1, 3
            end

            """
        ),
        (
            "paths.xml",
            """
            <?xml version="1.0"?>
            <scene><objects>
            <object class="vehiclenode" guid="{0}"><transform><object><position x="0" y="-200" z="30" /></object></transform>
            <attributes><attribute name="Density" value="0.5" /><attribute name="Streetname" value="hash_12345678" /></attributes></object>
            <object class="vehiclenode" guid="{1}"><transform><object><position x="0" y="0" z="30" /></object></transform>
            <attributes><attribute name="Speed" value="2" /><attribute name="Highway" value="true" /></attributes></object>
            <object class="vehiclelink" guid="{l}"><transform />
            <attributes><attribute name="Width" value="2" /><attribute name="Lanes In" value="2" /></attributes>
            <children /><references><ref guid="{0}" /><ref guid="{1}" /></references></object>
            </objects></scene>

            """
        ),
        (
            "nodes.ynd.xml",
            """
            <?xml version="1.0" encoding="UTF-8"?>
            <NodeDictionary>
             <VehicleNodeCount value="2" />
             <PedNodeCount value="0" />
             <Nodes>
              <Item><AreaID value="495" /><NodeID value="0" /><StreetName>hash_12345678</StreetName>
               <Position x="0" y="-200" z="30" />
               <Flags0 value="0" /><Flags1 value="0" /><Flags2 value="64" /><Flags3 value="0" /><Flags4 value="8" /><Flags5 value="2" />
               <Links><Item><ToAreaID value="495" /><ToNodeID value="1" />
                <Flags0 value="0" /><Flags1 value="0" /><Flags2 value="36" /><LinkLength value="200" /></Item></Links></Item>
              <Item><AreaID value="495" /><NodeID value="1" /><StreetName>hash_12345678</StreetName>
               <Position x="0" y="-10" z="30" />
               <Flags0 value="0" /><Flags1 value="0" /><Flags2 value="0" /><Flags3 value="0" /><Flags4 value="8" /><Flags5 value="2" />
               <Links><Item><ToAreaID value="495" /><ToNodeID value="0" />
                <Flags0 value="0" /><Flags1 value="0" /><Flags2 value="36" /><LinkLength value="200" /></Item></Links></Item>
             </Nodes>
            </NodeDictionary>

            """
        ),
        (
            "plan.json",
            """
            {"name": "fuzz", "seed": 7, "places": [{"name": "a", "x": 1.5, "y": -2, "headingDegrees": 90, "metres": 50},
             {"name": "b", "path": [[0, -40], [0, 40]], "seconds": 20}], "weathers": ["clear", "rain"], "hours": ["07:30", "12:00"],
             "cameras": [{"name": "wide", "width": 64, "height": 48, "verticalFovDegrees": 90}, {"name": "pair", "rig": "rig.json"}],
             "repetitions": 2, "frames": 3, "hz": 5,
             "speed": 10, "traffic": 0.5, "pedestrians": 1, "parked": 2, "masks": "rays"}

            """
        ),
        (
            "recipe.json",
            """
            {"version": 1, "tool": "harvester 0.1.0",
             "inputs": [{"name": "more"}],
             "steps": [{"folder": "rain", "command": ["harvest", "--frames", "5", "--weather", "rain", "--roads=@more"]},
              {"folder": "coco", "command": ["export", "@rain", "--format", "coco"],
               "sha256": "0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef"}]}

            """
        ),
        (
            "staged.json",
            """
            {"name": "staged", "places": [{"name": "a", "scenario": "scenario.json"}], "frames": 3}

            """
        ),
        (
            "scenario.xosc",
            """
            <?xml version="1.0" encoding="utf-8"?>
            <OpenSCENARIO>
              <FileHeader revMajor="1" revMinor="2" date="2000-01-01T00:00:00" description="fuzz (cutIn): A cut-in." author="a" />
              <Entities>
                <ScenarioObject name="Ego"><Vehicle name="car" vehicleCategory="car" /></ScenarioObject>
                <ScenarioObject name="a"><Vehicle name="car" vehicleCategory="van"><Properties>
                  <Property name="gtaModel" value="car" /></Properties></Vehicle></ScenarioObject>
              </Entities>
              <Storyboard>
                <Init><Actions>
                  <Private entityRef="Ego"><PrivateAction><LongitudinalAction><SpeedAction>
                    <SpeedActionDynamics dynamicsShape="step" dynamicsDimension="time" value="0" />
                    <SpeedActionTarget><AbsoluteTargetSpeed value="9" /></SpeedActionTarget>
                  </SpeedAction></LongitudinalAction></PrivateAction></Private>
                  <Private entityRef="a"><PrivateAction><TeleportAction><Position>
                    <RelativeLanePosition entityRef="Ego" dLane="1" ds="14.5" offset="0"><Orientation type="relative" h="0" />
                    </RelativeLanePosition></Position></TeleportAction></PrivateAction></Private>
                </Actions></Init>
                <Story name="s"><Act name="t"><ManeuverGroup name="g" maximumExecutionCount="1">
                  <Actors selectTriggeringEntities="false"><EntityRef entityRef="a" /></Actors>
                  <Maneuver name="m"><Event name="in" priority="override" maximumExecutionCount="1">
                    <Action name="c"><PrivateAction><LateralAction><LaneChangeAction>
                      <LaneChangeActionDynamics dynamicsShape="sinusoidal" dynamicsDimension="time" value="2" />
                      <LaneChangeTarget><RelativeTargetLane entityRef="Ego" value="0" /></LaneChangeTarget>
                    </LaneChangeAction></LateralAction></PrivateAction></Action>
                    <StartTrigger><ConditionGroup><Condition name="n" delay="0.5" conditionEdge="none"><ByEntityCondition>
                      <TriggeringEntities triggeringEntitiesRule="any"><EntityRef entityRef="Ego" /></TriggeringEntities>
                      <EntityCondition><RelativeDistanceCondition entityRef="a" relativeDistanceType="euclidianDistance"
                        freespace="false" rule="lessOrEqual" value="20" /></EntityCondition>
                    </ByEntityCondition></Condition></ConditionGroup></StartTrigger>
                  </Event></Maneuver>
                </ManeuverGroup></Act></Story>
                <StopTrigger><ConditionGroup><Condition name="end" delay="0" conditionEdge="none"><ByValueCondition>
                  <SimulationTimeCondition rule="greaterOrEqual" value="9" /></ByValueCondition></Condition></ConditionGroup></StopTrigger>
              </Storyboard>
            </OpenSCENARIO>

            """
        ),
        (
            "scenario.json",
            """
            {"name": "fuzz", "kind": "cutIn", "parameters": {"gap": {"min": 10, "max": 20}, "speed": [8, 10], "late": 2},
             "ego": {"speed": "$speed", "turn": "straight"}, "place": {"lanesLeft": 1, "straightMetres": 50,
             "junction": {"within": [20, 80], "light": true, "approaches": ["left"]}, "crossing": [10, 90]},
             "actors": [{"id": "a", "type": "vehicle", "model": "car", "start": {"metresAhead": "$gap*0.5+3", "lane": "left"}},
              {"id": "b", "type": "pedestrian", "start": {"roadside": "pavement", "metresAhead": 30, "headingDegrees": 90}},
              {"id": "c", "type": "cyclist", "start": {"approach": "left", "secondsBefore": -1}, "speed": 4},
              {"id": "d", "type": "object", "model": "cone", "start": {"x": 1, "y": 2, "headingDegrees": 3}}],
             "events": [{"id": "in", "actor": "a", "when": {"all": [{"seconds": "$late"}]}, "do": {"action": "cutIn", "seconds": 2}},
              {"id": "go", "actor": "b", "when": {"any": [{"egoArrival": 3, "actor": "b"}, {"ended": "in"}]}, "delay": 1,
               "do": {"action": "cross", "degrees": 90, "metres": 12, "speed": 1.5}},
              {"id": "way", "actor": "c", "do": {"action": "followPath", "points": [[0, 0], [5, 1]], "speed": 3}},
              {"id": "fast", "actor": "a", "do": {"action": "speedProfile", "profile": [[0, 5], [2, 9]]}}],
             "end": {"seconds": 12, "metres": 90, "egoPassedAll": true, "collision": true}}

            """
        ),
        (
            "rig.json",
            """
            {"name": "pair", "cameras": [{"name": "LEFT", "position": [0, 1.7, 1.5], "verticalFovDegrees": 39, "width": 64, "height": 48}],
             "lidars": [{"name": "TOP", "model": "HDL-32E", "position": [0, 0.94, 1.84], "rateHz": 20}],
             "radars": [{"name": "AHEAD", "position": [0, 3.9, 0.5], "clutter": 2}]}

            """
        ),
        (
            "nodes.json",
            """
            [{"AreaId": 495, "Nodes": [
              {"Id": 0, "StreetName": "0", "IsValidForGps": true, "IsJunction": false, "IsFreeway": true, "IsGravelRoad": false,
               "IsBackroad": false, "IsOnWater": false, "IsPedCrossway": false, "TrafficlightExists": false, "LeftTurnNoReturn": false,
               "RightTurnNoReturn": false, "Position": {"X": 0, "Y": -200, "Z": 30}, "ConnectedNodes": [{"Node":
              {"Id": 1, "StreetName": "0", "IsValidForGps": true, "IsJunction": false, "IsFreeway": true, "IsGravelRoad": false,
               "IsBackroad": false, "IsOnWater": false, "IsPedCrossway": false, "TrafficlightExists": false, "LeftTurnNoReturn": false,
               "RightTurnNoReturn": false, "Position": {"X": 0, "Y": -10, "Z": 30}, "ConnectedNodes": null},
               "LaneCountForward": 2, "LaneCountBackward": 1}]},
              {"Id": 1, "StreetName": "0", "IsValidForGps": true, "IsJunction": false, "IsFreeway": true, "IsGravelRoad": false,
               "IsBackroad": false, "IsOnWater": false, "IsPedCrossway": false, "TrafficlightExists": false, "LeftTurnNoReturn": false,
               "RightTurnNoReturn": false, "Position": {"X": 0, "Y": -10, "Z": 30}, "ConnectedNodes": []}]}]

            """
        ),
    ];

    /// <summary>Writes them into a folder.</summary>
    public static void WriteTo(string folder)
    {
        Directory.CreateDirectory(Path.Combine(folder, "survey", "photos"));
        foreach ((string name, string content) in All)
        {
            File.WriteAllText(Path.Combine(folder, name), content);
        }

        File.WriteAllBytes(Path.Combine(folder, "a.tape"), TapeBytes.Of(TapeBytes.Every));
    }

    private static string Event(int id, string kind, string participants, string measures) =>
        $"{{\"id\":{id},\"kind\":\"{kind}\",\"beginSeconds\":0.5,\"peakSeconds\":0.6,\"endSeconds\":0.7,\"end\":\"over\","
        + $"\"firstFrame\":null,\"lastFrame\":null,\"participants\":[{participants}],\"measures\":{{{measures}}}}}\n";

    /// <summary>One that drives north at 5 m/s.</summary>
    private static string Participant(string id, string kind) =>
        $"{{\"object\":{id},\"class\":{kind},\"model\":\"blista\",\"position\":[0,0,0],\"right\":[1,0,0],\"forward\":[0,1,0],"
        + "\"up\":[0,0,1],\"modelMin\":[-1,-2,0],\"modelMax\":[1,2,1],\"velocity\":[0,5,0],\"yawRate\":0}";
}
