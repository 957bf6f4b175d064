using System.Runtime.InteropServices;

namespace Harvester.Runs.Ports;

/// <summary>The signal that stops a run, for the programs that it has started.</summary>
public interface IStopSignal
{
    /// <summary>The signal to pass on.</summary>
    PosixSignal Signal { get; }

    /// <summary>Whether the programs that the run has started have the signal already, because they share its terminal.</summary>
    bool IsShared { get; }
}
