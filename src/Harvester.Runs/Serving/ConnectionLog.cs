using Harvester.Driving.Bridge;
using Harvester.Runs.Ports;

namespace Harvester.Runs.Serving;

/// <summary>Notes the connections, disconnections and problems of a bridge.</summary>
public sealed class ConnectionLog(IDrivingBridge bridge, IRunLog log)
{
    private string? _client;
    private string? _problem;

    /// <summary>Notes what has changed since the last call.</summary>
    /// <param name="problem">The last problem; null if there has been none.</param>
    public void Update(string? problem)
    {
        string? client = bridge.Client;
        if (client != _client)
        {
            if (_client is not null)
            {
                log.Note($"Disconnected: {_client}");
            }

            if (client is not null)
            {
                log.Note($"Connected: {client}");
            }

            _client = client;
        }

        if (problem is not null && problem != _problem)
        {
            _problem = problem;
            log.Warn(problem);
        }
    }
}
