using System.Text;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Text;

namespace Harvester.Driving.Bridge;

/// <summary>The texts of both bridges, specified in docs/bridge.md.</summary>
internal static class BridgeText
{
    private const int Decimals = 6;

    /// <summary>
    /// The content of state.txt: a line of thirteen numbers as in Figure 23 of the thesis, and a line with frame, time, speed, fast, the
    /// image's name and the angle ahead.
    /// </summary>
    public static byte[] StateFile(BridgeState state, string picture)
    {
        var text = new StringBuilder();
        foreach (double value in IndicatorOrder.Values(state.TorcsEquivalent))
        {
            Append(text, value);
        }

        text[text.Length - 1] = '\n';
        Append(text, state.Frame);
        Append(text, state.TimeSeconds);
        Append(text, state.SpeedMetresPerSecond);
        Append(text, state.IsFast ? 1 : 0);
        text.Append(picture).Append(' ');
        InvariantNumber.Append(text, state.Indicators.Angle.Value, Decimals);
        text.Append('\n');
        return Encoding.ASCII.GetBytes(text.ToString());
    }

    /// <summary>The header of an image on the socket.</summary>
    public static byte[] Header(BridgeState state)
    {
        var json = new JsonText();
        json.BeginObject()
            .Key("type")
            .String("frame")
            .Key("frame")
            .Integer(state.Frame)
            .Key("timeSeconds")
            .Number(state.TimeSeconds, Decimals)
            .Key("speedMetresPerSecond")
            .Number(state.SpeedMetresPerSecond, Decimals)
            .Key("position")
            .Vector(state.Position, Decimals)
            .Key("headingDegrees")
            .Number(state.HeadingDegrees, Decimals)
            .Key("fast")
            .Boolean(state.IsFast)
            .Key("lanesKnown")
            .Boolean(state.AreLanesKnown);
        AppendIndicators(json.Key("indicators"), state.Indicators);
        AppendIndicators(json.Key("torcsEquivalent"), state.TorcsEquivalent);
        AppendTruth(json, state.Truth);
        json.EndObject();
        return Encoding.UTF8.GetBytes(json.ToString());
    }

    /// <summary>A header that reports an error of the client.</summary>
    public static byte[] Error(string reason)
    {
        var json = new JsonText();
        json.BeginObject().Key("type").String("error").Key("reason").String(reason).EndObject();
        return Encoding.UTF8.GetBytes(json.ToString());
    }

    private static void AppendTruth(JsonText json, DrivingTruth? truth)
    {
        json.Key("drivenMetres").Number(truth?.DrivenMetres, Decimals).Key("collision").String(truth?.Collision);
        AppendNumbers(json.Key("collisions"), truth is null ? null : Array.ConvertAll([.. truth.Collisions], static n => (double)n));
        json.Key("outsideLanes")
            .Boolean(truth?.IsOutsideLanes)
            .Key("road")
            .Integer(truth?.Road)
            .Key("lane")
            .Integer(truth?.Lane)
            .Key("acrossMarking")
            .Boolean(truth?.IsAcrossMarking)
            .Key("laneOffsetMetres")
            .Number(truth?.LaneOffsetMetres, Decimals)
            .Key("laneAngleRadians")
            .Number(truth?.LaneAngleRadians, Decimals)
            .Key("redLightsRun")
            .Integer(truth?.RedLightsRun)
            .Key("stopSignsRun")
            .Integer(truth?.StopSignsRun)
            .Key("repositioned")
            .Integer(truth?.Repositioned)
            .Key("route")
            .String(truth?.Route)
            .Key("routeMetres")
            .Number(truth?.RouteMetres, Decimals)
            .Key("light")
            .String(truth?.Light)
            .Key("stopSign")
            .Boolean(truth?.HasStopSign);
        AppendNumbers(
            json.Key("appliedControls"),
            truth?.Applied is { } applied ? [applied.Steering, applied.Throttle, applied.Brake] : null
        );
        json.Key("builtInDriver").Boolean(truth?.IsByBuiltInDriver);
    }

    private static void AppendNumbers(JsonText json, double[]? numbers)
    {
        if (numbers is null)
        {
            json.Null();
            return;
        }

        json.BeginArray();
        foreach (double number in numbers)
        {
            json.Number(number, Decimals);
        }

        json.EndArray();
    }

    private static void AppendIndicators(JsonText json, LaneIndicators indicators) =>
        AppendNumbers(json, [.. IndicatorOrder.Values(indicators)]);

    private static void Append(StringBuilder text, double value)
    {
        InvariantNumber.Append(text, value, Decimals);
        text.Append(' ');
    }
}
