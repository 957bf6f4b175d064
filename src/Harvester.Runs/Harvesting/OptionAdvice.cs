using Harvester.Capture.Faults;

namespace Harvester.Runs.Harvesting;

/// <summary>Adds the option that helps to the faults of a harvest.</summary>
public static class OptionAdvice
{
    private const string SkipCheck = "To skip this check, add --max-camera-error 0.";

    /// <summary>What helps when little space is left on the disk.</summary>
    public const string OnLowSpace = "The same command with --resume continues; --min-free sets the limit.";

    /// <summary>The message of a fault, one line.</summary>
    public static string TextOf(CaptureFault fault) => OptionFor(fault.Code) is { } option ? $"{fault.Message} {option}" : fault.Message;

    private static string? OptionFor(FaultCode code) =>
        code switch
        {
            FaultCode.PictureLate => "To allow more, raise --max-picture-lag.",
            FaultCode.MarkersHidden => $"The field of view is set by --fov. {SkipCheck}",
            FaultCode.ViewNotShown => "See --freeze.",
            FaultCode.CameraModelOff or FaultCode.CameraUnchecked or FaultCode.CalibrationFailed => SkipCheck,
            _ => null,
        };
}
