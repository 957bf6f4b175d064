using System.Net;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Text;

namespace Harvester.Play.Settings;

/// <summary>The section [Bridge] of a settings file.</summary>
public sealed record BridgeSettings
{
    private const string Bridge = "Bridge";

    private const double DefaultRecordSeconds = 0.2;

    // The former name of ClientPatience; files with it are still read.
    private const string OldClientPatience = "PeerPatience";

    /// <summary>The kind of bridge.</summary>
    public required BridgeKind Kind { get; init; }

    /// <summary>The shared folder.</summary>
    public required string Folder { get; init; }

    /// <summary>Time without a sign of life after which the client of a shared folder counts as disconnected, seconds.</summary>
    public required double ClientPatienceSeconds { get; init; }

    /// <summary>Where the socket listens, and for which clients.</summary>
    public required SocketBridgeOptions Socket { get; init; }

    /// <summary>The controller that drives by the indicators of a client.</summary>
    public required ControllerPlan Controller { get; init; }

    /// <summary>Frame rate and size of the images.</summary>
    public required DrivingOptions Driving { get; init; }

    /// <summary>Game time between two recorded frames, seconds; null if drives are not recorded.</summary>
    public required double? RecordSeconds { get; init; }

    /// <summary>Number of ticks by which the picture of a running game lags behind the state, for recorded drives.</summary>
    public required int RecordLagTicks { get; init; }

    /// <summary>Address or folder of the bridge, for display.</summary>
    public string Place => Kind == BridgeKind.Folder ? Folder : $"{Socket.Address}:{Socket.Port}";

    /// <summary>Opens the bridge. It may take a while, as when the folder is on another machine.</summary>
    /// <exception cref="System.IO.IOException">The folder cannot be created.</exception>
    /// <exception cref="UnauthorizedAccessException">The folder may not be created.</exception>
    /// <exception cref="System.Net.Sockets.SocketException">The address or port is not available.</exception>
    /// <exception cref="ArgumentException">The address is not a loopback address and there is no token.</exception>
    /// <exception cref="InvalidOperationException">The bridge is off.</exception>
    public IDrivingBridge Open() =>
        Kind switch
        {
            BridgeKind.Folder => new FolderBridge(Folder, Driving.Picture, ClientPatienceSeconds),
            BridgeKind.Socket => new SocketBridge(Socket, Driving.Picture),
            _ => throw new InvalidOperationException("The bridge is off."),
        };

    /// <summary>The settings of a file; missing and invalid values have their defaults.</summary>
    /// <param name="ini">The file.</param>
    /// <param name="defaultFolder">The shared folder if the file names none.</param>
    /// <param name="pathOf">Completes a path of the file.</param>
    public static BridgeSettings Read(IniFile ini, string defaultFolder, Func<string, string> pathOf)
    {
        if (ini is null || pathOf is null)
        {
            throw new ArgumentNullException(ini is null ? nameof(ini) : nameof(pathOf));
        }

        var driving = new DrivingOptions();
        bool isRecorded = ini.Choice(Bridge, "Record", Switch.Off, "On or Off") == Switch.On;
        double recordSeconds = ini.Number(Bridge, "RecordSeconds", DefaultRecordSeconds, 0.02, 60);
        string token = ini.Text(Bridge, "Token", string.Empty);
        return new BridgeSettings
        {
            Kind = ini.Choice(Bridge, "Kind", BridgeKind.Socket, "Socket, Folder or Off"),
            Folder = pathOf(ini.Text(Bridge, "Folder", defaultFolder)),
            ClientPatienceSeconds = ini.Number(
                Bridge,
                "ClientPatience",
                ini.Number(Bridge, OldClientPatience, FolderBridge.DefaultPatienceSeconds, 1, 86_400),
                1,
                86_400
            ),
            Socket = new SocketBridgeOptions(
                ini.Address(Bridge, "Address", IPAddress.Loopback),
                ini.Whole(Bridge, "Port", SocketBridgeOptions.DefaultPort, 1, 65_535),
                token.Length > 0 ? token : null
            ),
            Controller = new ControllerPlan
            {
                LookAheadMetres = 0,
                Kind = ini.Choice(Bridge, "Controller", ControllerKind.DeepDriving, "DeepDriving or Stanley"),
                BrakesInEmergency = ini.Choice(Bridge, "EmergencyBrake", Switch.Off, "On or Off") == Switch.On,
            },
            Driving = driving with
            {
                RateHz = ini.Number(Bridge, "Rate", driving.RateHz, 0.1, 60),
                Picture = new ImageSize(
                    ini.Whole(Bridge, "Width", driving.Picture.Width, 16, 1920),
                    ini.Whole(Bridge, "Height", driving.Picture.Height, 16, 1080)
                ),
            },
            RecordLagTicks = ini.Whole(Bridge, "RecordLag", 0, 0, driving.SettleTicks),
            RecordSeconds = isRecorded ? recordSeconds : null,
        };
    }
}
