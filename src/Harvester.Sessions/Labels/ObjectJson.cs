using Harvester.Geometry.Boxes;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>Writes an object of a label.</summary>
internal static class ObjectJson
{
    public static void Append(JsonText json, ObjectLabel label)
    {
        json.BeginObject()
            .Key("id")
            .Integer(label.Id)
            .Key("class")
            .String(JsonName.Of(label.Class))
            .Key("model")
            .String(label.Model)
            .Key("name")
            .String(label.Name)
            .Key("parent")
            .Integer(label.Parent)
            .Key("knownParts")
            .Integer(label.KnownParts)
            .Key("hasRider")
            .Boolean(label.HasRider);
        if (label.Class == ObjectClass.Rider)
        {
            json.Key("vehicle").Integer(label.Vehicle);
        }

        json.Key("box2d")
            .Box(label.Box2D, LabelDecimals.Pixels)
            .Key("box2dAmodal")
            .Box(label.Box2DAmodal, LabelDecimals.Pixels)
            .Key("box2dVisible")
            .Box(label.Box2DVisible, LabelDecimals.Pixels);
        if (label.Box2DWhole is { } whole)
        {
            json.Key("box2dWhole").Box(whole, LabelDecimals.Pixels);
        }

        json.Key("boxes").BeginArray();
        foreach (BoxKind kind in label.Boxes)
        {
            json.String(JsonName.Of(kind));
        }

        json.EndArray()
            .Key("truncatedFraction")
            .Number(label.TruncatedFraction, LabelDecimals.Fraction)
            .Key("occludedFraction")
            .Number(label.OccludedFraction, LabelDecimals.Fraction)
            .Key("occlusionMethod")
            .String(JsonName.Of(label.OcclusionMethod))
            .Key("visibleFraction")
            .Number(label.VisibleFraction, LabelDecimals.Fraction);
        if (label.TrueOccludedFraction is { } hidden)
        {
            json.Key("trueOccludedFraction").Number(hidden, LabelDecimals.Fraction);
        }

        Append(json.Key("box3d"), label.Box3D);
        json.Key("distanceMetres")
            .Number(label.DistanceMetres, LabelDecimals.Metres)
            .Key("velocity")
            .Vector(label.Velocity, LabelDecimals.Speed);
        if (label.LaneId is { } lane)
        {
            json.Key("laneId").String(lane);
        }

        if (label.GovernedLanes is { } governed)
        {
            json.Key("governedLanes").BeginArray();
            foreach (string each in governed)
            {
                json.String(each);
            }

            json.EndArray();
        }

        if (label.AmodalMask is { } amodal)
        {
            Append(json.Key("amodalMask"), amodal);
        }

        FaceJson.Append(json.Key("space"), label.Face);
        VehicleLightsJson.Append(json, label.Lights);
        if (label.Joints is { } joints)
        {
            JointsJson.Append(json, joints);
        }

        json.EndObject();
    }

    private static void Append(JsonText json, AmodalMask mask)
    {
        json.BeginObject()
            .Key("box")
            .BeginArray()
            .Integer(mask.Left)
            .Integer(mask.Top)
            .Integer(mask.Width)
            .Integer(mask.Height)
            .EndArray()
            .Key("runs")
            .BeginArray();
        foreach (int run in mask.Runs)
        {
            json.Integer(run);
        }

        json.EndArray().EndObject();
    }

    private static void Append(JsonText json, Cuboid cuboid)
    {
        json.BeginObject()
            .Key("centre")
            .Vector(cuboid.Centre, LabelDecimals.Metres)
            .Key("halfExtents")
            .Vector(cuboid.HalfExtents, LabelDecimals.Metres);
        AxesJson.Append(json, cuboid.Axes);
        json.EndObject();
    }
}
