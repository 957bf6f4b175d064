using Harvester.Cli.Terminals;
using Harvester.Driving.Bridge;

namespace Harvester.Cli.Serving;

/// <summary>Says who connects to a bridge, who leaves it, and what goes wrong.</summary>
internal sealed class VisitLog(IDrivingBridge bridge, Terminal terminal)
{
    private string? _peer;
    private string? _problem;

    /// <summary>Looks; to be called often.</summary>
    /// <param name="problem">The last thing that went wrong; null when nothing has.</param>
    public void Look(string? problem)
    {
        string? peer = bridge.Peer;
        if (peer != _peer)
        {
            if (_peer is not null)
            {
                terminal.Out.WriteLine($"Disconnected: {_peer}");
            }

            if (peer is not null)
            {
                terminal.Out.WriteLine($"Connected: {peer}");
            }

            terminal.Out.Flush();
            _peer = peer;
        }

        if (problem is not null && problem != _problem)
        {
            _problem = problem;
            terminal.WriteError(problem);
        }
    }
}
