using Harvester.Geometry.Lanes;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>Writes the lanes of a label line.</summary>
internal static class LanesJson
{
    private const int CurvatureDecimals = 6;
    private const int AngleDecimals = 6;

    public static void Append(JsonText json, LanesLabel lanes)
    {
        json.BeginObject()
            .Key("status")
            .String(JsonName.Of(lanes.Status))
            .Key("source")
            .String(lanes.Source)
            .Key("confidence")
            .Number(lanes.Confidence, LabelDecimals.Fraction)
            .Key("inJunction")
            .Boolean(lanes.InJunction)
            .Key("laneCount")
            .Integer(lanes.LaneCount)
            .Key("lane")
            .Integer(lanes.Lane);
        AppendNames(json, lanes);
        json.Key("laneWidthMetres").Number(lanes.LaneWidthMetres, LabelDecimals.Metres);
        AppendWidths(json, lanes.LaneWidthsMetres);
        json.Key("laneWidthSource")
            .String(lanes.LaneWidthSource is { } source ? JsonName.Of(source) : null)
            .Key("offsetFromLaneCentreMetres")
            .Number(lanes.OffsetFromLaneCentreMetres, LabelDecimals.Metres)
            .Key("lookAheadMetres")
            .Number(lanes.LookAheadMetres, LabelDecimals.Metres)
            .Key("curvaturePerMetre")
            .Number(lanes.CurvaturePerMetre, CurvatureDecimals)
            .Key("fast")
            .Boolean(lanes.IsFast);
        AppendValues(json.Key("indicators"), lanes.Indicators);
        AppendFlags(json.Key("valid"), lanes.Indicators);
        AppendValues(json.Key("torcsEquivalent"), lanes.TorcsEquivalent);
        json.Key("atCar").BeginObject();
        AppendValues(json.Key("indicators"), lanes.IndicatorsAtCar);
        AppendFlags(json.Key("valid"), lanes.IndicatorsAtCar);
        json.EndObject();
        AppendVehicles(json.Key("vehicles"), lanes.Vehicles);
        AppendLines(json.Key("boundaries"), lanes.Boundaries);
        if (lanes.Markings is { } markings)
        {
            AppendLines(json.Key("markings"), markings);
        }
        else
        {
            json.Key("markings").String(null);
        }

        json.EndObject();
    }

    private static void AppendNames(JsonText json, LanesLabel lanes)
    {
        if (lanes.LanesAhead is not { } ahead)
        {
            return;
        }

        json.Key("laneId").String(lanes.LaneId).Key("lanesAhead").BeginArray();
        foreach (string lane in ahead)
        {
            json.String(lane);
        }

        json.EndArray();
    }

    private static void AppendWidths(JsonText json, IReadOnlyList<double>? widths)
    {
        if (widths is null)
        {
            return;
        }

        json.Key("laneWidthsMetres").BeginArray();
        foreach (double width in widths)
        {
            json.Number(width, LabelDecimals.Metres);
        }

        json.EndArray();
    }

    private static void AppendValues(JsonText json, LaneIndicators indicators)
    {
        json.BeginObject();
        foreach (IndicatorDefinition indicator in IndicatorTable.All)
        {
            int decimals = indicator.Quantity == IndicatorQuantity.Angle ? AngleDecimals : LabelDecimals.Metres;
            json.Key(indicator.Name).Number(indicator.Of(indicators).Value, decimals);
        }

        json.EndObject();
    }

    private static void AppendFlags(JsonText json, LaneIndicators indicators)
    {
        json.BeginObject();
        foreach (IndicatorDefinition indicator in IndicatorTable.All)
        {
            json.Key(indicator.Name).Boolean(indicator.Of(indicators).IsValid);
        }

        json.EndObject();
    }

    private static void AppendVehicles(JsonText json, IReadOnlyList<VehicleInLane> vehicles)
    {
        json.BeginArray();
        foreach (VehicleInLane vehicle in vehicles)
        {
            json.BeginObject()
                .Key("id")
                .Integer(vehicle.Id)
                .Key("lane")
                .Integer(vehicle.Lane)
                .Key("oncoming")
                .Boolean(vehicle.IsOncoming)
                .Key("distanceMetres")
                .Number(vehicle.DistanceMetres, LabelDecimals.Metres)
                .Key("bumperDistanceMetres")
                .Number(vehicle.BumperDistanceMetres, LabelDecimals.Metres)
                .EndObject();
        }

        json.EndArray();
    }

    private static void AppendLines(JsonText json, IReadOnlyList<LaneLineView> lines)
    {
        json.BeginArray();
        foreach (LaneLineView line in lines)
        {
            json.BeginObject().Key("index").Integer(line.Index).Key("side").String(line.IsLeftOfCar ? "left" : "right");
            if (line.Paint is { } paint)
            {
                json.Key("style")
                    .String(JsonName.Of(paint.Style))
                    .Key("colour")
                    .String(JsonName.Of(paint.Colour))
                    .Key("widthMetres")
                    .Number(paint.WidthMetres, LabelDecimals.Metres);
                if (line.SigmaMetres is { } sigma)
                {
                    json.Key("source").String("paint").Key("sigmaMetres").Number(sigma, LabelDecimals.Metres);
                }

                AppendEach(json.Key("painted"), line, point => json.Boolean(point.IsPainted));
            }

            AppendEach(json.Key("points"), line, point => json.Vector(point.World, LabelDecimals.Metres));
            AppendEach(json.Key("inCamera"), line, point => json.Vector(point.InCamera, LabelDecimals.Metres));
            AppendEach(
                json.Key("pixels"),
                line,
                point =>
                    json.BeginArray().Number(point.Pixel.X, LabelDecimals.Pixels).Number(point.Pixel.Y, LabelDecimals.Pixels).EndArray()
            );
            AppendEach(json.Key("hidden"), line, point => json.Boolean(point.IsHidden));
            json.EndObject();
        }

        json.EndArray();
    }

    private static void AppendEach(JsonText json, LaneLineView line, Action<LaneLinePoint> append)
    {
        json.BeginArray();
        foreach (LaneLinePoint point in line.Points)
        {
            append(point);
        }

        json.EndArray();
    }
}
