using Harvester.Geometry;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>Writes the action that belongs to a frame of a recorded drive.</summary>
internal static class DriveJson
{
    private const int IndicatorDecimals = 6;
    private const int AngleDecimals = 6;
    private const int ControlDecimals = 6;
    private const int InertialDecimals = 5;

    /// <summary>Writes the action with its key; nothing if the session is no recorded drive.</summary>
    public static void Append(JsonText json, DriveLabel? drive)
    {
        if (drive is null)
        {
            return;
        }

        json.Key("drive").BeginObject().Key("driver").String(JsonName.Of(drive.Driver));
        Append(json.Key("controls"), drive.Controls);
        json.Key("answerSeconds").Number(drive.AnswerSeconds, LabelDecimals.Seconds);
        Append(json.Key("applied"), drive.Applied);
        json.Key("disturbed").Boolean(drive.IsDisturbed);
        Append(json.Key("indicators"), drive.Indicators);
        Append(json.Key("target"), drive.Target);
        json.Key("route")
            .String(drive.Route)
            .Key("routeMetres")
            .Number(drive.RouteMetres, LabelDecimals.Metres)
            .Key("speed")
            .Number(drive.SpeedMetresPerSecond, LabelDecimals.Speed);
        Append(json.Key("acceleration"), drive.Acceleration);
        Append(json.Key("angularRate"), drive.AngularRate);
        json.Key("bridgeFrame").Integer(drive.BridgeFrame);
        Append(json.Key("truth"), drive.Truth);
        json.Key("ticks").BeginArray();
        foreach (DriveTick tick in drive.Ticks)
        {
            json.BeginObject()
                .Key("timeSeconds")
                .Number(tick.TimeSeconds, LabelDecimals.Seconds)
                .Key("driver")
                .String(JsonName.Of(tick.Driver))
                .Key("speed")
                .Number(tick.SpeedMetresPerSecond, LabelDecimals.Speed);
            Append(json.Key("acceleration"), tick.Acceleration);
            Append(json.Key("angularRate"), tick.AngularRate);
            Append(json.Key("applied"), tick.Applied);
            json.EndObject();
        }

        json.EndArray().EndObject();
    }

    private static void Append(JsonText json, DriveControls? controls)
    {
        if (controls is not { } set)
        {
            json.Null();
            return;
        }

        json.BeginObject()
            .Key("steering")
            .Number(set.Steering, ControlDecimals)
            .Key("throttle")
            .Number(set.Throttle, ControlDecimals)
            .Key("brake")
            .Number(set.Brake, ControlDecimals)
            .EndObject();
    }

    private static void Append(JsonText json, DriveTarget? target)
    {
        if (target is not { } known)
        {
            json.Null();
            return;
        }

        json.BeginObject()
            .Key("speed")
            .Number(known.SpeedMetresPerSecond, LabelDecimals.Speed)
            .Key("rightMetres")
            .Number(known.RightMetres, LabelDecimals.Metres)
            .EndObject();
    }

    private static void Append(JsonText json, IReadOnlyList<double>? numbers)
    {
        if (numbers is null)
        {
            json.Null();
            return;
        }

        json.BeginArray();
        foreach (double number in numbers)
        {
            json.Number(number, IndicatorDecimals);
        }

        json.EndArray();
    }

    private static void Append(JsonText json, Vector3D? vector)
    {
        if (vector is { } known)
        {
            json.Vector(known, InertialDecimals);
        }
        else
        {
            json.Null();
        }
    }

    private static void Append(JsonText json, DriveTruth? truth)
    {
        if (truth is null)
        {
            json.Null();
            return;
        }

        json.BeginObject()
            .Key("drivenMetres")
            .Number(truth.DrivenMetres, LabelDecimals.Metres)
            .Key("collision")
            .String(truth.Collision)
            .Key("outsideLanes")
            .Boolean(truth.IsOutsideLanes)
            .Key("laneOffsetMetres")
            .Number(truth.LaneOffsetMetres, LabelDecimals.Metres)
            .Key("laneAngleRadians")
            .Number(truth.LaneAngleRadians, AngleDecimals)
            .Key("light")
            .String(truth.Light)
            .Key("stopSign")
            .Boolean(truth.HasStopSign)
            .Key("redLightsRun")
            .Integer(truth.RedLightsRun)
            .Key("stopSignsRun")
            .Integer(truth.StopSignsRun)
            .Key("repositioned")
            .Integer(truth.Repositioned)
            .EndObject();
    }
}
