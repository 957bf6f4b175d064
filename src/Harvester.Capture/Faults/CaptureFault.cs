namespace Harvester.Capture.Faults;

/// <summary>A fault of a harvest or calibration.</summary>
/// <param name="Code">What kind it is; front ends choose their advice by it.</param>
/// <param name="Message">One line with the measured values that says what happened. It names no option and no setting.</param>
public sealed record CaptureFault(FaultCode Code, string Message);
