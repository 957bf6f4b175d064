using Harvester.Cli.Terminals;
using Harvester.Driving.Bridge;

namespace Harvester.Cli.Serving;

/// <summary>Says who connects to a bridge, who leaves it, and what goes wrong.</summary>
internal sealed class VisitLog(IDrivingBridge bridge, Terminal terminal)
{
    private string? _client;
    private string? _problem;

    /// <summary>Looks; to be called often.</summary>
    /// <param name="problem">The last thing that went wrong; null when nothing has.</param>
    public void Look(string? problem)
    {
        string? client = bridge.Client;
        if (client != _client)
        {
            if (_client is not null)
            {
                terminal.Out.WriteLine($"Disconnected: {_client}");
            }

            if (client is not null)
            {
                terminal.Out.WriteLine($"Connected: {client}");
            }

            terminal.Out.Flush();
            _client = client;
        }

        if (problem is not null && problem != _problem)
        {
            _problem = problem;
            terminal.WriteError(problem);
        }
    }
}
