using System;
using System.Collections.Generic;
using System.IO;
using System.Net;
using System.Net.Sockets;
using System.Threading;
using System.Threading.Tasks;
using Harvester.Capture.Driving;
using Harvester.Capture.Driving.Bridge;
using Harvester.Capture.Driving.Controllers;
using Harvester.Capture.Ports;
using Harvester.Cli.Arguments;
using Harvester.Driving.Evaluation;
using Harvester.Driving.Peers;
using Harvester.Geometry.Cameras;
using Harvester.Simulation;

namespace Harvester.Cli.Driving;

/// <summary>Sets up the sides of a bridge that a plan asks for.</summary>
internal sealed class BridgedDrives(BridgePlan plan)
{
    /// <summary>The simulated game goes on by so much with each answer of a peer of its own: ten frames a second.</summary>
    private const double StepSeconds = 0.1;

    /// <summary>Lets a simulated game be driven over the bridge.</summary>
    /// <param name="game">The game.</param>
    /// <param name="roads">Its roads.</param>
    /// <param name="newController">Drives as the peer, or here by the indicators that a peer sends.</param>
    /// <param name="metres">How far.</param>
    /// <param name="seconds">How long at most.</param>
    /// <param name="cancellation">Ends it.</param>
    /// <exception cref="IOException">The bridge cannot be opened.</exception>
    public IReadOnlyList<DriveSample> Run(
        SimulatedGame game, IRoads roads, Func<IController> newController, double metres, double seconds, CancellationToken cancellation)
    {
        bool isAlone = plan.Role == DriveRole.Both;
        using IDrivingBridge bridge = Open(isAlone);
        BridgedDrive drive = new(game, roads, bridge, newController);
        if (!isAlone)
        {
            return drive.Run(metres, seconds, isRealTime: true, cancellation);
        }

        using var ending = CancellationTokenSource.CreateLinkedTokenSource(cancellation);
        using IPeerLink link = Connect((bridge as SocketBridge)?.EndPoint);
        Task peer = Task.Run(() => new PeerDriver(link, newController()).Run(StepSeconds, double.PositiveInfinity, ending.Token), CancellationToken.None);
        try
        {
            return drive.Run(metres, seconds, isRealTime: false, cancellation);
        }
        finally
        {
            ending.Cancel();
            peer.Wait(CancellationToken.None);
        }
    }

    /// <summary>Drives a game elsewhere, which goes its own way.</summary>
    /// <returns>Frames answered, and the way of the car, metres.</returns>
    /// <exception cref="IOException">Nobody is there.</exception>
    public (long Frames, double Metres) RunPeer(IController controller, double seconds, CancellationToken cancellation)
    {
        using IPeerLink link = Connect(null);
        PeerDriver driver = new(link, controller);
        driver.Run(null, seconds, cancellation);
        return (driver.Frames, driver.Metres);
    }

    private IDrivingBridge Open(bool isAlone)
    {
        ImageSize picture = new DrivingOptions().Picture;
        if (plan.Kind == BridgeName.Folder)
        {
            return new FolderBridge(plan.Folder, picture);
        }

        IPEndPoint at = plan.At ?? (isAlone ? new IPEndPoint(IPAddress.Loopback, 0) : DriveBridgeOptions.Usual);
        try
        {
            return new SocketBridge(new SocketBridgeOptions(at.Address, at.Port, plan.Token), picture);
        }
        catch (SocketException e)
        {
            throw new IOException($"No bridge can be opened at {at}: {e.Message}", e);
        }
        catch (ArgumentException e)
        {
            throw new UsageException(e.Message);
        }
    }

    private IPeerLink Connect(IPEndPoint? known)
    {
        IPEndPoint at = known ?? plan.At ?? DriveBridgeOptions.Usual;
        return plan.Kind == BridgeName.Folder ? new FolderLink(plan.Folder) : new SocketLink(at.Address.ToString(), at.Port, plan.Token);
    }
}
