using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Sessions.Reading;

/// <summary>Reads the lanes of a label line.</summary>
internal static class LanesParser
{
    public static LanesLabel Parse(JsonFields lanes) =>
        new()
        {
            Status = lanes.Name<LaneStatus>("status"),
            Source = lanes.Text("source"),
            Confidence = lanes.Number("confidence"),
            InJunction = lanes.Boolean("inJunction"),
            LaneCount = lanes.Has("laneCount") ? lanes.Integer("laneCount") : null,
            Lane = lanes.Has("lane") ? lanes.Integer("lane") : null,
            LaneId = lanes.OptionalText("laneId"),
            LanesAhead = lanes.Has("lanesAhead") ? lanes.Texts("lanesAhead") : null,
            LaneWidthMetres = lanes.OptionalNumber("laneWidthMetres"),
            LaneWidthsMetres = lanes.Has("laneWidthsMetres") ? lanes.Numbers("laneWidthsMetres") : null,
            LaneWidthSource = lanes.Has("laneWidthSource") ? lanes.Name<LaneWidthSource>("laneWidthSource") : null,
            OffsetFromLaneCentreMetres = lanes.OptionalNumber("offsetFromLaneCentreMetres"),
            LookAheadMetres = lanes.Number("lookAheadMetres"),
            CurvaturePerMetre = lanes.Number("curvaturePerMetre"),
            IsFast = lanes.Boolean("fast"),
            Indicators = ReadIndicators(lanes.Fields("indicators"), lanes.Fields("valid")),
            TorcsEquivalent = ReadIndicators(lanes.Fields("torcsEquivalent"), lanes.Fields("valid")),
            IndicatorsAtCar = ReadIndicators(lanes.Fields("atCar").Fields("indicators"), lanes.Fields("atCar").Fields("valid")),
            Vehicles = [.. lanes.List("vehicles").Select(ReadVehicle)],
            Boundaries = [.. lanes.List("boundaries").Select(ReadLine)],
            Markings = lanes.Has("markings") ? [.. lanes.List("markings").Select(ReadMarking)] : null,
        };

    private static LaneIndicators ReadIndicators(JsonFields values, JsonFields valid) =>
        LaneIndicators.From(indicator => new Indicator(values.Number(indicator.Name), valid.Boolean(indicator.Name)));

    private static VehicleInLane ReadVehicle(JsonFields vehicle) =>
        new(
            vehicle.Integer("id"),
            vehicle.Integer("lane"),
            vehicle.Boolean("oncoming"),
            vehicle.Number("distanceMetres"),
            vehicle.Number("bumperDistanceMetres")
        );

    private static LaneLineView ReadMarking(JsonFields marking)
    {
        LaneLineView line = ReadLine(marking);
        bool?[] painted = marking.OptionalBooleans("painted");
        return painted.Length != line.Points.Count
            ? throw new DatasetFormatException("painted and points of a marking must have the same length.")
            : line with
            {
                Points = [.. line.Points.Select((point, i) => point with { IsPainted = painted[i] == true })],
                Paint = new MarkingPaint(
                    marking.Name<MarkingStyle>("style"),
                    marking.Name<MarkingColour>("colour"),
                    marking.Number("widthMetres")
                ),
                SigmaMetres = marking.OptionalNumber("sigmaMetres"),
            };
    }

    private static LaneLineView ReadLine(JsonFields line)
    {
        Vector3D[] points = line.Vectors("points");
        Vector3D[] inCamera = line.Vectors("inCamera");
        Vector2D[] pixels = line.Points("pixels");
        bool?[] hidden = line.OptionalBooleans("hidden");
        if (inCamera.Length != points.Length || pixels.Length != points.Length || hidden.Length != points.Length)
        {
            throw new DatasetFormatException("points, inCamera, pixels and hidden of a boundary or marking must have the same length.");
        }

        return new LaneLineView(
            line.Integer("index"),
            line.Text("side") == "left",
            [.. points.Select((point, i) => new LaneLinePoint(point, inCamera[i], pixels[i], hidden[i]))]
        );
    }
}
