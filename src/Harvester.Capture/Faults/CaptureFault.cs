namespace Harvester.Capture.Faults;

/// <summary>A fault of a harvest or calibration.</summary>
/// <param name="Code">The kind of fault; front ends choose their advice by it.</param>
/// <param name="Message">What happened, in one line with the measured values. It names no option or setting.</param>
public sealed record CaptureFault(FaultCode Code, string Message);
