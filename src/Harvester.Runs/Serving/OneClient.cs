using System.Diagnostics;
using Harvester.Driving.Bridge;

namespace Harvester.Runs.Serving;

/// <summary>Notices when the first client of a bridge has disconnected, or when none has come.</summary>
public sealed class OneClient(IAwaitableBridge bridge)
{
    /// <summary>Time for the client to connect: a program that has started the game and died never does.</summary>
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(60);

    private readonly Stopwatch _waiting = Stopwatch.StartNew();

    /// <summary>Whether the client has gone, or none has connected within a minute.</summary>
    public bool IsGone() => bridge.Client is null && (bridge.ClientsGone > 0 || _waiting.Elapsed > Patience);
}
