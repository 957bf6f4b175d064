using Harvester.Cli.Terminals;
using Harvester.Driving.Bridge;

namespace Harvester.Cli.Serving;

/// <summary>Prints the connections, disconnections and problems of a bridge.</summary>
internal sealed class ConnectionLog(IDrivingBridge bridge, Terminal terminal)
{
    private string? _client;
    private string? _problem;

    /// <summary>Prints what has changed since the last call.</summary>
    /// <param name="problem">The last problem; null if there has been none.</param>
    public void Update(string? problem)
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
