using System.CommandLine;
using System.Net;
using Harvester.Driving.Bridge;
using Harvester.Driving.Session;
using Harvester.Runs.Driving;
using Harvester.Runs.Faults;

namespace Harvester.Cli.Arguments;

/// <summary>The options of the bridge that serve opens: a folder, or the address of a socket.</summary>
internal sealed class BridgeOptions
{
    private readonly Option<string?> _folder = new("--folder")
    {
        Description = "Exchange files in this folder instead of listening on a socket",
        HelpName = "DIR",
    };
    private readonly Option<string> _address = new("--address")
    {
        Description = "IP address to listen on; any but a loopback address requires --token",
        HelpName = "ADDRESS",
        DefaultValueFactory = _ => IPAddress.Loopback.ToString(),
    };

    private readonly Option<int> _port = ValueParsers.Integer(
        "--port",
        "N",
        "Port to listen on; 0 for any free port",
        0,
        IPEndPoint.MaxPort
    );
    private readonly Option<string?> _token = new("--token") { Description = "Secret that a client must send", HelpName = "WORD" };

    public BridgeOptions()
    {
        _port.DefaultValueFactory = _ => SocketBridgeOptions.DefaultPort;
    }

    /// <summary>Adds the options to a command.</summary>
    public void AddTo(Command command)
    {
        command.Options.Add(_folder);
        command.Options.Add(_address);
        command.Options.Add(_port);
        command.Options.Add(_token);
    }

    /// <summary>The folder of a folder bridge as it was given; null for a socket.</summary>
    public string? FolderOf(ParseResult parsed) => parsed.GetValue(_folder);

    /// <summary>Opens the bridge of a command line.</summary>
    /// <param name="parsed">The command line.</param>
    /// <param name="driving">Has the size of the images.</param>
    /// <param name="place">Receives the folder, or the address and port, that clients use.</param>
    /// <exception cref="Datasets.Files.OccupiedFolderException">The folder has files that are not a bridge's.</exception>
    /// <exception cref="UsageException">The address is invalid, or needs a token.</exception>
    /// <exception cref="IOException">The folder cannot be created, or the address or port is not available.</exception>
    public IAwaitableBridge Open(ParseResult parsed, DrivingOptions driving, out string place)
    {
        if (parsed.GetValue(_folder) is { } folder)
        {
            BridgeFolder.Check(folder);
            place = Path.GetFullPath(folder);
            return new FolderBridge(place, driving.Picture);
        }

        string address = parsed.GetRequiredValue(_address);
        if (!IPAddress.TryParse(address, out IPAddress? parsedAddress))
        {
            throw new UsageException($"--address takes an IP address, e.g. 127.0.0.1, not '{address}'.");
        }

        SocketBridge bridge = SocketBridges.Open(
            new IPEndPoint(parsedAddress, parsed.GetValue(_port)),
            parsed.GetValue(_token),
            driving.Picture,
            canRestart: driving.IsLockStep
        );
        place = bridge.EndPoint.ToString();
        return bridge;
    }
}
