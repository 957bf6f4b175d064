using Harvester.Capture.Ports;
using Harvester.Geometry;

namespace Harvester.Play.Features;

/// <summary>A staged actor in the game: its entities, and the order that the game's tasks carry out.</summary>
/// <param name="game">The game.</param>
/// <param name="isVehicle">Whether it drives.</param>
internal sealed class ActorInGame(IActorGame game, bool isVehicle)
{
    /// <summary>
    /// The game's flags of driving: for other vehicles, for people, at lights; backwards; straight to the place, off the lanes.
    /// </summary>
    private const int StopsForVehicles = 1;
    private const int StopsForPeople = 2;
    private const int StopsAtLights = 128;
    private const int Backwards = 1024;
    private const int Straight = 16_777_216;

    /// <summary>The next place of a task is ahead by this, metres, and by the way of this time, seconds.</summary>
    private const double MinAhead = 12;
    private const double AheadSeconds = 3;

    /// <summary>A new task is given when this share of the way to its place is left, so that the game is not always planning.</summary>
    private const double RenewedAt = 0.5;

    private const int BrakeMilliseconds = 60_000;
    private const double RunsFrom = 2;
    private const double SprintsFrom = 4.5;

    private StageOrder? _order;
    private ActorPath? _path;
    private Vector3D? _target;
    private double _aheadAtTask;

    /// <summary>The vehicle, person, animal or thing; 0 before it is there.</summary>
    public int Entity { get; set; }

    /// <summary>The driver, or the person itself; 0 for a thing.</summary>
    public int Ped { get; set; }

    /// <summary>Whether it is at the end of its path, or has none.</summary>
    public bool IsAtEnd { get; private set; } = true;

    /// <summary>Gives an order, which is carried out from the next tick on.</summary>
    public void Follow(StageOrder order)
    {
        (_order, _path, _target, IsAtEnd) = (order, new ActorPath(order.Path), null, false);
    }

    /// <summary>Changes the speed; the game decides how fast it is reached.</summary>
    public void SetSpeed(double speed)
    {
        if (_order is null)
        {
            return;
        }

        _order = _order with { Speed = speed };
        if (Ped == 0 || Entity == 0)
        {
            return;
        }

        if (speed == 0)
        {
            Halt();
        }
        else if (isVehicle && _target is not null)
        {
            game.SetCruiseSpeed(Ped, speed);
        }
        else
        {
            _target = null;
        }
    }

    /// <summary>Gives the game's tasks the next place, when that is due.</summary>
    public void Tick()
    {
        if (_order is not { Speed: > 0 } order || _path is null || IsAtEnd || Ped == 0 || !game.Exists(Ped))
        {
            return;
        }

        Vector3D place = game.PoseOf(Entity).Position;
        double ahead = MinAhead + (order.Speed * AheadSeconds);
        Vector3D next = _path.Ahead(place, ahead);
        if (_path.IsEnd(place))
        {
            IsAtEnd = true;
            Halt();
            return;
        }

        if (_target is { } target && (target - place).Length > RenewedAt * _aheadAtTask)
        {
            return;
        }

        (_target, _aheadAtTask) = (next, Math.Min(ahead, (next - place).Length));
        if (isVehicle)
        {
            game.DriveTo(Ped, Entity, next, order.Speed, StyleOf(order));
        }
        else
        {
            game.WalkTo(
                Ped,
                next,
                order.Speed < RunsFrom ? 1
                    : order.Speed < SprintsFrom ? 2
                    : 3
            );
        }
    }

    private void Halt()
    {
        _target = null;
        if (isVehicle)
        {
            game.Brake(Ped, Entity, BrakeMilliseconds);
        }
        else
        {
            game.ClearTasks(Ped);
        }
    }

    private static int StyleOf(StageOrder order) =>
        Straight
        | (order.IgnoresOthers ? 0 : StopsForVehicles | StopsForPeople)
        | (order.IgnoresLights ? 0 : StopsAtLights)
        | (order.IsBackwards ? Backwards : 0);
}
