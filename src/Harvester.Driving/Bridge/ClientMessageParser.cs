using System.Globalization;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Driving.Bridge;

/// <summary>Reads the header of a client's message. Fields, units and ranges: docs/bridge.md.</summary>
public static class ClientMessageParser
{
    private const double MaxStepSeconds = 10;
    private const double MaxCoordinate = 100_000;
    private const double MaxHeadingDegrees = 360;

    /// <summary>Parses a header.</summary>
    /// <exception cref="BridgeException">The header is not a valid message; the exception says what is wrong.</exception>
    public static ClientMessage Parse(string header)
    {
        HeaderFields fields = HeaderFields.Parse(header ?? throw new ArgumentNullException(nameof(header)));
        string type = fields.Text("type");
        return type switch
        {
            "controls" => new ControlsMessage(
                new DrivingControls(fields.Number("steering"), fields.Number("throttle"), fields.Number("brake")),
                FrameOf(fields)
            ),
            "indicators" => IndicatorsOf(fields.Numbers("values", IndicatorTable.Count), FrameOf(fields)),
            "reset" => new ResetMessage(PositionOf(fields), HeadingOf(fields)),
            "environment" => new EnvironmentMessage(
                fields.Has("weather") ? WeatherOf(fields) : null,
                fields.Has("timeOfDay") ? TimeOf(fields) : null
            ),
            "pause" => new PauseMessage(fields.Boolean("paused")),
            "step" => new StepMessage(SecondsOf(fields), HasPicture(fields)),
            "requestFrame" => new RequestFrameMessage(HasPicture(fields)),
            "restart" => new RestartMessage(SeedOf(fields, "seed"), fields.Has("town") ? SeedOf(fields, "town") : null, HasPicture(fields)),
            _ => throw new BridgeException(
                $"type {ClientText.Quoted(type)} is not one of controls, indicators, reset, environment, pause, step, requestFrame, "
                    + "restart."
            ),
        };
    }

    /// <summary>A message with thirteen indicators.</summary>
    /// <exception cref="BridgeException">One is out of range.</exception>
    internal static IndicatorsMessage IndicatorsOf(double[] values, long? frame) =>
        Array.TrueForAll(values, value => Math.Abs(value) <= IndicatorOrder.MaxValue)
            ? new IndicatorsMessage(values, frame)
            : throw new BridgeException(
                FormattableString.Invariant($"indicators must be from -{IndicatorOrder.MaxValue} to {IndicatorOrder.MaxValue}.")
            );

    /// <summary>Converts a number to a frame number.</summary>
    /// <exception cref="BridgeException">The number is not a whole number of 0 or more.</exception>
    internal static long FrameOf(double number)
    {
        const double maxExact = 9007199254740992;
        return number >= 0 && number <= maxExact && Math.Floor(number) == number
            ? (long)number
            : throw new BridgeException("the frame must be a whole number, 0 or more.");
    }

    private static long? FrameOf(HeaderFields fields) => fields.Has("frame") ? FrameOf(fields.Number("frame")) : null;

    private static bool HasPicture(HeaderFields fields) => !fields.Has("image") || fields.Boolean("image");

    private static int SeedOf(HeaderFields fields, string name)
    {
        double number = fields.Number(name);
        return number >= 0 && number <= int.MaxValue && Math.Floor(number) == number
            ? (int)number
            : throw new BridgeException(FormattableString.Invariant($"field {name} must be a whole number from 0 to {int.MaxValue}."));
    }

    private static Vector3D PositionOf(HeaderFields fields)
    {
        double[] position = fields.Numbers("position", 3);
        return Array.TrueForAll(position, coordinate => Math.Abs(coordinate) <= MaxCoordinate)
            ? new Vector3D(position[0], position[1], position[2])
            : throw new BridgeException("field position is out of range.");
    }

    private static double HeadingOf(HeaderFields fields)
    {
        double degrees = fields.Number("headingDegrees");
        return Math.Abs(degrees) <= MaxHeadingDegrees
            ? degrees
            : throw new BridgeException("field headingDegrees must be from -360 to 360.");
    }

    private static string WeatherOf(HeaderFields fields)
    {
        string weather = fields.Text("weather");
        return WeatherNames.IsKnown(weather)
            ? weather
            : throw new BridgeException(
                $"field weather is {ClientText.Quoted(weather)}, which is not one of {string.Join(", ", WeatherNames.All)}."
            );
    }

    private static TimeSpan TimeOf(HeaderFields fields) =>
        TimeSpan.TryParseExact(fields.Text("timeOfDay"), "hh\\:mm", CultureInfo.InvariantCulture, out TimeSpan time)
            ? time
            : throw new BridgeException("field timeOfDay must be a time such as 17:30.");

    private static double SecondsOf(HeaderFields fields)
    {
        double seconds = fields.Number("seconds");
        return seconds > 0 && seconds <= MaxStepSeconds
            ? seconds
            : throw new BridgeException("field seconds must be more than 0 and at most 10.");
    }
}
