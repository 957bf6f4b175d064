using System.Net;
using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.Geometry.Cameras;
using Harvester.Runs.Clients;
using Harvester.Runs.Evaluation.Figures;
using Harvester.Runs.Faults;
using Harvester.Simulation.Game;

namespace Harvester.Runs.Driving;

/// <summary>Sets up the bridge of a drive and runs its sides.</summary>
/// <param name="plan">The bridge and the sides to run.</param>
/// <param name="messages">Receives a line with the address at which the drive waits for a client.</param>
public sealed class BridgeSetup(BridgePlan plan, TextWriter messages)
{
    /// <summary>Records the drive; null for none.</summary>
    public GameRecording? Recording { get; init; }

    /// <summary>Game time per answer of a client in this process: ten frames per second.</summary>
    private const double StepSeconds = 0.1;

    /// <summary>Runs the game's side: a client drives the simulated game over the bridge.</summary>
    /// <param name="game">The game.</param>
    /// <param name="roads">Its roads.</param>
    /// <param name="newController">Creates the controller of a client in this process.</param>
    /// <param name="newControllerAtCar">Creates the controller for indicators that a client sends, with the angle at the car.</param>
    /// <param name="metres">Distance to drive, metres.</param>
    /// <param name="seconds">Time limit, seconds of game time.</param>
    /// <param name="samples">Receives the samples of the drive, also if a fault ends it.</param>
    /// <param name="cancellation">Ends the drive.</param>
    /// <exception cref="IOException">The bridge cannot be opened or fails, or the other side does not answer.</exception>
    /// <exception cref="GameFaultException">The game failed.</exception>
    public void Run(
        SimulatedGame game,
        IRoads roads,
        Func<IController> newController,
        Func<IController> newControllerAtCar,
        double metres,
        double seconds,
        List<DriveSample> samples,
        CancellationToken cancellation
    )
    {
        bool isAlone = plan.Role == DriveRole.Both;
        using IDrivingBridge bridge = Open(isAlone);
        BridgeDrive drive = new(game, roads, bridge, newControllerAtCar, plan.Patience) { Recording = Recording };
        try
        {
            Run(drive, bridge, newController, metres, seconds, cancellation);
        }
        finally
        {
            samples.AddRange(drive.Samples);
        }
    }

    /// <summary>Runs the client's side: drives a game in another process.</summary>
    /// <returns>The client, with the figures of the drive.</returns>
    /// <exception cref="IOException">The game cannot be reached or does not answer, or the bridge fails.</exception>
    public ClientDriver RunClient(Func<IController> newController, double seconds, CancellationToken cancellation)
    {
        using IBridgeLink link = Connect(null);
        ClientDriver driver = new(link, newController, plan.Patience, TimeProvider.System);
        driver.Run(null, seconds, cancellation);
        return driver;
    }

    private void Run(
        BridgeDrive drive,
        IDrivingBridge bridge,
        Func<IController> newController,
        double metres,
        double seconds,
        CancellationToken cancellation
    )
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
        Task client = Task.Run(
            () => RunClientToItsEnd(new ClientDriver(link, newController, plan.Patience, TimeProvider.System), ending),
            CancellationToken.None
        );
        try
        {
            drive.Run(metres, seconds, isRealTime: false, ending.Token);
        }
        catch
        {
            // The game's fault is reported; the client's is only its consequence.
            ending.Cancel();
            ((IAsyncResult)client).AsyncWaitHandle.WaitOne();
            throw;
        }

        ending.Cancel();
        client.GetAwaiter().GetResult();
    }

    /// <summary>Runs the client. When it ends, for any reason, the drive ends too, because nothing would step the world.</summary>
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
        if (plan.Kind == BridgeName.Folder)
        {
            return new FolderBridge(plan.Folder, picture);
        }

        IPEndPoint usual = isAlone ? new IPEndPoint(IPAddress.Loopback, 0) : BridgePlan.DefaultAddress;
        return SocketBridges.Open(plan.At ?? usual, plan.Token, picture);
    }

    private IBridgeLink Connect(IPEndPoint? known)
    {
        IPEndPoint at = known ?? plan.At ?? BridgePlan.DefaultAddress;
        return plan.Kind == BridgeName.Folder
            ? new FolderLink(plan.Folder)
            : new SocketLink(at.Address.ToString(), at.Port, plan.Token, plan.Patience);
    }
}
