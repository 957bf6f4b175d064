using Harvester.Capture.Faults;

namespace Harvester.Play.Features;

/// <summary>
/// Turns the faults of a harvest into messages for the player: the core's message and the setting that changes the limit.
/// </summary>
internal static class HarvestAdvice
{
    private const string SkipCheck = "To skip this check, set MaxError = 0 under [Lens].";

    /// <summary>The message in one line.</summary>
    public static string TextOf(CaptureFault fault) =>
        SettingFor(fault.Code) is { } setting ? $"{fault.Message} {setting}" : FailureAdvice.AddTo(fault.Message);

    private static string? SettingFor(FaultCode code) =>
        code switch
        {
            FaultCode.PictureLate => "To allow more, raise MaxPictureLagTicks under [Harvest].",
            FaultCode.MarkersHidden or FaultCode.CameraModelOff or FaultCode.CameraUnchecked or FaultCode.CalibrationFailed => SkipCheck,
            FaultCode.LagUnknown => "Mode = Freeze under [Harvest] freezes the game.",
            _ => null,
        };
}
