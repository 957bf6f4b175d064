using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Sessions.Reading;

/// <summary>Reads the action that belongs to a frame of a recorded drive.</summary>
internal static class DriveParser
{
    private const string Field = "drive";

    /// <summary>The action; null if the session is no recorded drive.</summary>
    /// <exception cref="DatasetFormatException">A field is invalid.</exception>
    public static DriveLabel? Parse(JsonFields frame)
    {
        if (!frame.Has(Field))
        {
            return null;
        }

        JsonFields drive = frame.Fields(Field);
        return new DriveLabel(drive.Name<DriverKind>("driver"), drive.Number("speed"))
        {
            Controls = ControlsOf(drive, "controls"),
            AnswerSeconds = drive.OptionalNumber("answerSeconds"),
            Applied = ControlsOf(drive, "applied"),
            IsDisturbed = drive.Boolean("disturbed"),
            Indicators = IndicatorsOf(drive),
            Target = drive.Has("target") ? TargetOf(drive.Fields("target")) : null,
            Route = drive.OptionalText("route"),
            RouteMetres = drive.OptionalNumber("routeMetres"),
            Acceleration = VectorOf(drive, "acceleration"),
            AngularRate = VectorOf(drive, "angularRate"),
            BridgeFrame = drive.Has("bridgeFrame") ? drive.LongInteger("bridgeFrame") : null,
            Truth = drive.Has("truth") ? TruthOf(drive.Fields("truth")) : null,
            Ticks = [.. drive.List("ticks").Select(TickOf)],
        };
    }

    private static DriveTarget TargetOf(JsonFields target) => new(target.Number("speed"), target.OptionalNumber("rightMetres"));

    private static DriveTick TickOf(JsonFields tick) =>
        new(tick.Number("timeSeconds"), tick.Number("speed"), tick.Name<DriverKind>("driver"))
        {
            Acceleration = VectorOf(tick, "acceleration"),
            AngularRate = VectorOf(tick, "angularRate"),
            Applied = ControlsOf(tick, "applied"),
        };

    private static DriveTruth TruthOf(JsonFields truth) =>
        new(truth.Number("drivenMetres"), truth.Boolean("outsideLanes"), truth.Boolean("stopSign"))
        {
            Collision = truth.OptionalText("collision"),
            LaneOffsetMetres = truth.OptionalNumber("laneOffsetMetres"),
            LaneAngleRadians = truth.OptionalNumber("laneAngleRadians"),
            Light = truth.OptionalText("light"),
            RedLightsRun = truth.Integer("redLightsRun"),
            StopSignsRun = truth.Integer("stopSignsRun"),
            Repositioned = truth.Integer("repositioned"),
        };

    private static DriveControls? ControlsOf(JsonFields fields, string name)
    {
        if (!fields.Has(name))
        {
            return null;
        }

        JsonFields controls = fields.Fields(name);
        return new DriveControls(controls.Number("steering"), controls.Number("throttle"), controls.Number("brake"));
    }

    private static double[]? IndicatorsOf(JsonFields drive)
    {
        const string name = "indicators";
        return drive.Has(name) ? drive.Numbers(name, Geometry.Lanes.IndicatorTable.Count) : null;
    }

    private static Vector3D? VectorOf(JsonFields fields, string name) => fields.Has(name) ? fields.Vector(name) : null;
}
