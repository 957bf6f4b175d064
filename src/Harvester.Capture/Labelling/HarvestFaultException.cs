using Harvester.Capture.Faults;

namespace Harvester.Capture.Labelling;

/// <summary>Ends a harvest with a fault for the user. A session catches it; relabelling throws it to its caller.</summary>
public sealed class HarvestFaultException(CaptureFault fault) : Exception(fault.Message)
{
    /// <summary>The fault.</summary>
    public CaptureFault Fault { get; } = fault;
}
