using Harvester.Capture.Faults;

namespace Harvester.Capture.Calibration;

/// <summary>Ends a calibration with a fault for the user. It is caught within the session.</summary>
internal sealed class CalibrationException(CaptureFault fault) : Exception(fault.Message)
{
    public CalibrationException(string message)
        : this(new CaptureFault(FaultCode.CalibrationFailed, message)) { }

    public CaptureFault Fault { get; } = fault;
}
