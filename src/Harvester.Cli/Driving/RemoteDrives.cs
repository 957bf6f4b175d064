using System;
using System.Collections.Generic;
using System.IO;
using System.Net;
using System.Threading;
using System.Threading.Tasks;
using Harvester.Capture.Ports;
using Harvester.Cli.Terminals;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.Evaluation.Clients;
using Harvester.Evaluation.Figures;
using Harvester.Geometry.Cameras;
using Harvester.Simulation.Game;

namespace Harvester.Cli.Driving;

/// <summary>Sets up the sides of a bridge that a plan asks for.</summary>
/// <param name="plan">What is asked for.</param>
/// <param name="messages">Receives a line that says where the drive waits for a client.</param>
internal sealed class RemoteDrives(BridgePlan plan, TextWriter messages)
{
    /// <summary>The simulated game goes on by so much with each answer of a client of its own: ten frames a second.</summary>
    private const double StepSeconds = 0.1;

    /// <summary>Lets a simulated game be driven over the bridge.</summary>
    /// <param name="game">The game.</param>
    /// <param name="roads">Its roads.</param>
    /// <param name="newController">Makes what drives as the client.</param>
    /// <param name="newControllerAtCar">Makes what drives here by the indicators that a client sends, with the angle at the car.</param>
    /// <param name="metres">How far.</param>
    /// <param name="seconds">How long at most.</param>
    /// <param name="samples">Gets what was driven, also when a fault ends it.</param>
    /// <param name="cancellation">Ends it.</param>
    /// <exception cref="IOException">The bridge cannot be opened or has failed, or the other side is silent.</exception>
    /// <exception cref="GameFaultException">The game failed.</exception>
    public void Run(
        SimulatedGame game,
        IRoads roads,
        Func<IController> newController,
        Func<IController> newControllerAtCar,
        double metres,
        double seconds,
        List<DriveSample> samples,
        CancellationToken cancellation)
    {
        bool isAlone = plan.Role == DriveRole.Both;
        using IDrivingBridge bridge = Open(isAlone);
        RemoteDrive drive = new(game, roads, bridge, newControllerAtCar, plan.Patience);
        try
        {
            Run(drive, bridge, newController, metres, seconds, cancellation);
        }
        finally
        {
            samples.AddRange(drive.Samples);
        }
    }

    /// <summary>Drives a game elsewhere, which goes its own way.</summary>
    /// <returns>The client, with what it has driven.</returns>
    /// <exception cref="IOException">Nobody is there, the bridge has failed, or the game is silent.</exception>
    public ClientDriver RunClient(Func<IController> newController, double seconds, CancellationToken cancellation)
    {
        using IBridgeLink link = Connect(null);
        ClientDriver driver = new(link, newController, plan.Patience, TimeProvider.System);
        driver.Run(null, seconds, cancellation);
        return driver;
    }

    private void Run(RemoteDrive drive, IDrivingBridge bridge, Func<IController> newController, double metres, double seconds,
        CancellationToken cancellation)
    {
        if (plan.Role != DriveRole.Both)
        {
            messages.WriteLine(FormattableString.Invariant($"Waiting up to {plan.Patience.TotalSeconds} s for a client at {plan.Place}"));
            messages.Flush();
            drive.Run(metres, seconds, isRealTime: true, cancellation);
            return;
        }

        using IBridgeLink link = Connect((bridge as SocketBridge)?.EndPoint);
        using var ending = CancellationTokenSource.CreateLinkedTokenSource(cancellation);
        Task client = Task.Run(() =>
            RunClientToItsEnd(new ClientDriver(link, newController, plan.Patience, TimeProvider.System), ending), CancellationToken.None);
        try
        {
            drive.Run(metres, seconds, isRealTime: false, ending.Token);
        }
        catch
        {
            // The game's fault is the one to tell; what it does to the client follows from it.
            ending.Cancel();
            ((IAsyncResult)client).AsyncWaitHandle.WaitOne();
            throw;
        }

        ending.Cancel();
        client.GetAwaiter().GetResult();
    }

    /// <summary>A client that has come to its end, in whatever way, ends the drive: nobody would step the world.</summary>
    private static void RunClientToItsEnd(ClientDriver driver, CancellationTokenSource ending)
    {
        try
        {
            driver.Run(StepSeconds, double.PositiveInfinity, ending.Token);
            if (driver.IsEndedByGame)
            {
                throw new IOException("The client closed the bridge during the drive.");
            }
        }
        finally
        {
            ending.Cancel();
        }
    }

    private IDrivingBridge Open(bool isAlone)
    {
        ImageSize picture = new DrivingOptions().Picture;
        return plan.Kind == BridgeName.Folder
            ? new FolderBridge(plan.Folder, picture)
            : SocketBridges.Open(plan.At ?? (isAlone ? new IPEndPoint(IPAddress.Loopback, 0) : BridgePlan.UsualPlace), plan.Token, picture);
    }

    private IBridgeLink Connect(IPEndPoint? known)
    {
        IPEndPoint at = known ?? plan.At ?? BridgePlan.UsualPlace;
        return plan.Kind == BridgeName.Folder ? new FolderLink(plan.Folder)
            : new SocketLink(at.Address.ToString(), at.Port, plan.Token, plan.Patience);
    }
}
