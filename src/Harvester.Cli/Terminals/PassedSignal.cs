using System.Runtime.InteropServices;
using Harvester.Runs.Ports;

namespace Harvester.Cli.Terminals;

/// <summary>The signal that stopped this program, to be passed on to the supervised one.</summary>
internal sealed class PassedSignal : IStopSignal, IDisposable
{
    private readonly PosixSignalRegistration _interrupt;
    private volatile bool _isInterrupt;

    /// <summary>Receives signals from now on.</summary>
    public PassedSignal() =>
        _interrupt = PosixSignalRegistration.Create(
            PosixSignal.SIGINT,
            signal =>
            {
                signal.Cancel = true;
                _isInterrupt = true;
            }
        );

    /// <inheritdoc/>
    public PosixSignal Signal => _isInterrupt ? PosixSignal.SIGINT : PosixSignal.SIGTERM;

    /// <summary>
    /// Whether the supervised program has the signal already: a terminal sends Ctrl+C to all its programs, and a second one would end a
    /// program at once.
    /// </summary>
    public bool IsShared => _isInterrupt && !Console.IsInputRedirected;

    /// <inheritdoc />
    public void Dispose() => _interrupt.Dispose();
}
