using Harvester.Capture.Ports;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Session;

/// <summary>
/// A drive in a game of 60 ticks a second, so that a frame at 10 Hz comes every sixth tick and half a second is 30 ticks.
/// </summary>
public abstract class DrivenGame : IDisposable
{
    private protected static readonly DrivingControls Left = new(0.5, 0.25, 0);

    private protected FakeGame Game { get; } = new();

    private protected FakeCar Car { get; } = new();

    private protected FakeBridge Bridge { get; } = new();

    public void Dispose()
    {
        Bridge.Dispose();
        GC.SuppressFinalize(this);
    }

    private protected DrivingSession Session(
        Func<IController>? controller = null,
        GamePorts? ports = null,
        DrivingOptions? options = null
    ) =>
        new(
            options ?? new DrivingOptions(),
            (ports ?? Game.Ports) with
            {
                Car = Car,
            },
            Bridge,
            controller ?? (() => new NotingController(Left))
        );

    private protected void Run(DrivingSession session, int ticks)
    {
        for (int tick = 0; tick < ticks; tick++)
        {
            session.Tick();
            Game.Tick();
        }
    }

    /// <summary>Always answers with the same controls, and records its input.</summary>
    private protected sealed class NotingController(DrivingControls answer) : IController
    {
        public List<DrivingState> States { get; } = [];

        public DrivingControls Drive(DrivingState state)
        {
            States.Add(state);
            return answer;
        }
    }
}
