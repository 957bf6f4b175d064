using Harvester.Sessions.Scenes;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>
/// The variety of the ego's built-in driver: it wanders in its lane, drifts onto markings and recovers, changes lanes and overtakes. It
/// decides only where across the road the car shall be; <see cref="OwnDriver"/> steers there. The same seed gives the same drive.
/// </summary>
internal sealed class EgoManoeuvres(Vehicle ego, LaneTravel lanes, int seed, double wander, double laneChanges)
{
    /// <summary>Standard deviation of the wandering at factor 1, metres.</summary>
    private const double WanderMetres = 0.55;
    private const double WanderSeconds = 3;
    private const double DriftsPerSecond = 0.28;
    private const double LaneChangesPerSecond = 0.2;
    private const double ShortestDriftSeconds = 1.5;
    private const double LongestDriftSeconds = 5;
    private const double PromptedDriftSeconds = 3;

    /// <summary>Room between the car's side and the border of its lane at which wandering ends, metres.</summary>
    private const double SideRoom = 0.1;

    /// <summary>How far the car's middle goes beyond a marking on which it drives, at most, metres.</summary>
    private const double BeyondMarking = 0.3;

    /// <summary>How far the wheels go onto a line that must not be crossed, at most, metres.</summary>
    private const double OntoLine = 0.12;

    /// <summary>Way along the lane that a drift or lane change needs before a junction, metres.</summary>
    private const double JunctionRoom = 30;
    private const double LastChance = 14;
    private const double SlowestSideways = 0.4;
    private const double FastestSideways = 2;
    private const double SidewaysAcceleration = 2.5;
    private const double Settled = 0.35;
    private const double FollowSeconds = 2.5;
    private const double FollowMetres = 8;
    private const double SlowLeader = 0.8;
    private const double StandingSpeed = 0.2;

    private readonly Random _random = new(seed);
    private LanePath? _path;
    private double _wander;
    private double _goal;
    private double _rate;
    private double _sideways;
    private double _secondsLeft;
    private int _lanesToGo;
    private LanePath? _passing;
    private double _passingSeconds;
    private int _promptedSide;

    /// <summary>Where the car shall be, metres to the right of its lane's line.</summary>
    public double Offset { get; private set; }

    /// <summary>What it is doing.</summary>
    public Manoeuvre Kind { get; private set; } = Manoeuvre.KeepLane;

    /// <summary>What a label says that it is doing.</summary>
    public Manoeuvre Reported(LaneOccupation occupation)
    {
        if (ego.Speed < StandingSpeed)
        {
            return Manoeuvre.Stop;
        }

        if (Kind != Manoeuvre.KeepLane)
        {
            return Kind;
        }

        if (_passing is not null)
        {
            return Manoeuvre.Overtake;
        }

        (double gap, _) = Driver.Leader(ego, occupation);
        return gap < FollowMetres + (FollowSeconds * ego.Speed) ? Manoeuvre.Follow
            : wander > 0 ? Manoeuvre.Wander
            : Manoeuvre.KeepLane;
    }

    /// <summary>Whether it is still to begin the drift that was asked for.</summary>
    public bool IsPrompted => _promptedSide != 0;

    /// <summary>Asks for a drift onto a marking as soon as there is room for it.</summary>
    /// <param name="side">-1 for a marking to the left, 1 for one to the right.</param>
    public void Prompt(int side) => _promptedSide = wander > 0 ? side : 0;

    /// <summary>Decides where to be after a time step.</summary>
    /// <param name="seconds">The time step.</param>
    /// <param name="rightOffset">Where the car is, metres to the right of its lane's line.</param>
    /// <param name="occupation">The vehicles on the lanes.</param>
    /// <param name="isClear">Whether nothing stands where the car would be at an offset, up to a distance ahead, both metres.</param>
    public void Tick(double seconds, double rightOffset, LaneOccupation occupation, Func<double, double, bool> isClear)
    {
        FollowPath();
        Wander(seconds);
        double left = ego.Path.Road is null ? 0 : ego.Path.Length - ego.Distance;
        switch (Kind)
        {
            case Manoeuvre.LaneChangeLeft or Manoeuvre.LaneChangeRight:
                if (_lanesToGo == 0 && Math.Abs(rightOffset) < Settled)
                {
                    Begin(Manoeuvre.KeepLane, _wander, SlowestSideways);
                }
                else if (_lanesToGo != 0 && left < LastChance)
                {
                    Begin(Manoeuvre.Recover, 0, FastestSideways);
                }

                break;
            case Manoeuvre.Drift:
                _secondsLeft -= seconds;
                if (_secondsLeft < 0 || left < LastChance || !isClear(_goal, LastChance))
                {
                    Begin(Manoeuvre.Recover, 0, SidewaysOf(1 + _random.NextDouble()));
                }

                break;
            case Manoeuvre.Recover:
                if (Math.Abs(rightOffset - _goal) < Settled)
                {
                    Begin(Manoeuvre.KeepLane, _wander, SlowestSideways);
                }

                break;
            default:
                _goal = Limited(_wander);
                Choose(seconds, left, occupation, isClear);
                break;
        }

        MoveOffset(seconds);
    }

    /// <summary>Discards the planned manoeuvre, as after the car was placed elsewhere or driven by another program.</summary>
    public void Reset(double rightOffset)
    {
        Kind = Manoeuvre.KeepLane;
        _path = ego.Path;
        _passing = null;
        _lanesToGo = 0;
        _sideways = 0;
        Offset = rightOffset;
        _rate = SlowestSideways;
    }

    private double HalfLane => (ego.Path.Road?.Layout.LaneWidth ?? 0) / 2;

    private double LimitOfLane => Math.Max(0, HalfLane - ego.Model.Max.X - SideRoom);

    /// <summary>After the middle of the car has crossed into another lane, offsets count from that lane's line.</summary>
    private void FollowPath()
    {
        LanePath? before = _path;
        _path = ego.Path;
        if (before == _path || before is null)
        {
            return;
        }

        if (before.Road is { } road && road == _path.Road && before.IsForward == _path.IsForward)
        {
            int lanesToTheRight = _path.Lane - before.Lane;
            _goal -= lanesToTheRight * road.Layout.LaneWidth;
            Offset -= lanesToTheRight * road.Layout.LaneWidth;
            _lanesToGo -= lanesToTheRight;
            if (Kind == Manoeuvre.Recover)
            {
                _goal = 0;
            }
        }
        else
        {
            _passing = null;
            _lanesToGo = 0;
            if (Kind != Manoeuvre.KeepLane && Kind != Manoeuvre.Recover)
            {
                Begin(Manoeuvre.Recover, 0, FastestSideways);
            }
        }
    }

    /// <summary>
    /// An Ornstein-Uhlenbeck process, dx = -x dt / τ + σ √(2 dt / τ) n, with the standard deviation σ and the time constant τ; n is normal
    /// by Box and Muller's transform.
    /// </summary>
    private void Wander(double seconds)
    {
        double noise = Math.Sqrt(-2 * Math.Log(1 - _random.NextDouble())) * Math.Cos(2 * Math.PI * _random.NextDouble());
        _wander += (-_wander * seconds / WanderSeconds) + (wander * WanderMetres * Math.Sqrt(2 * seconds / WanderSeconds) * noise);
    }

    private void Choose(double seconds, double left, LaneOccupation occupation, Func<double, double, bool> isClear)
    {
        bool drifts = _random.NextDouble() < seconds * DriftsPerSecond * wander;
        bool changes = _random.NextDouble() < seconds * LaneChangesPerSecond * laneChanges;
        int side = _random.Next(2) == 0 ? -1 : 1;
        double depth = _random.NextDouble();
        if (_passing is not null)
        {
            Pass(seconds, left, occupation);
            return;
        }

        if (left < JunctionRoom || ego.Granted.Count > 0 || ego.Speed < 2)
        {
            return;
        }

        (double gap, double leaderSpeed) = Driver.Leader(ego, occupation);
        bool isHeldUp = laneChanges > 0 && gap < FollowMetres + (FollowSeconds * ego.Speed) && leaderSpeed < SlowLeader * ego.CruiseSpeed;
        if (isHeldUp && left > 2 * JunctionRoom && TryChange(-1, occupation))
        {
            _passing = ego.Path;
            _passingSeconds = 0;
        }
        else if (changes)
        {
            _ = TryChange(side, occupation) || TryChange(-side, occupation);
        }
        else if (_promptedSide != 0)
        {
            Drift(_promptedSide, 1, occupation, isClear);
        }
        else if (drifts)
        {
            Drift(side, depth, occupation, isClear);
        }
    }

    /// <summary>Goes back to the right once there is a gap, or stays if there is none for long.</summary>
    private void Pass(double seconds, double left, LaneOccupation occupation)
    {
        const double atLeastSeconds = 2.5;
        const double atMostSeconds = 20;
        _passingSeconds += seconds;
        bool isBack = _passingSeconds > atLeastSeconds && left > JunctionRoom && TryChange(1, occupation);
        if (isBack || _passingSeconds > atMostSeconds || left < JunctionRoom)
        {
            _passing = null;
        }
    }

    private bool TryChange(int side, LaneOccupation occupation)
    {
        if (lanes.Beside(ego.Path, side) is not { } lane || !LaneTravel.HasGap(ego, lane, occupation))
        {
            return false;
        }

        Begin(side < 0 ? Manoeuvre.LaneChangeLeft : Manoeuvre.LaneChangeRight, side * 2 * HalfLane, SidewaysOf(_random.NextDouble()));
        _lanesToGo = side;
        return true;
    }

    private void Drift(int side, double depth, LaneOccupation occupation, Func<double, double, bool> isClear)
    {
        double within = LimitOfLane * (0.75 + (0.25 * depth));
        double onMarking = HalfLane - BeyondMarking + (2 * BeyondMarking * depth);
        LanePath? beside = lanes.Beside(ego.Path, side);
        bool isOpen = beside is null
            ? side > 0
                && ego.Path.Road is { IsInner: false, IsUnpaved: false } road
                && onMarking + ego.Model.Max.X < HalfLane + road.Shoulder
            : laneChanges > 0 && LaneTravel.HasGap(ego, beside, occupation);
        if (side < 0 && beside is null)
        {
            // The middle of the road or its left edge: the wheels reach the line and stay off the lane behind it.
            within = HalfLane - ego.Model.Max.X + (OntoLine * depth);
        }

        double goal = side * (isOpen && depth > 0.3 && isClear(side * onMarking, JunctionRoom) ? onMarking : within);
        if (isClear(goal, JunctionRoom))
        {
            double least = IsPrompted ? PromptedDriftSeconds : ShortestDriftSeconds;
            _promptedSide = 0;
            Begin(Manoeuvre.Drift, goal, SidewaysOf(depth));
            _secondsLeft = least + ((LongestDriftSeconds - least) * _random.NextDouble());
        }
    }

    private void Begin(Manoeuvre kind, double goal, double rate)
    {
        Kind = kind;
        _goal = goal;
        _rate = rate;
    }

    private static double SidewaysOf(double haste) =>
        Math.Min(FastestSideways, SlowestSideways + 0.3 + ((FastestSideways - SlowestSideways) * haste * 0.7));

    private double Limited(double offset)
    {
        double limit = ego.Path.Road is null ? 0 : LimitOfLane;
        return Math.Clamp(offset, -limit, limit);
    }

    /// <summary>The offset moves sideways no faster than the car can at its speed, and gently.</summary>
    private void MoveOffset(double seconds)
    {
        const double steepest = 0.25;
        double fastest = Math.Min(_rate, steepest * ego.Speed);
        double missing = _goal - Offset;

        // As fast as it can still be stopped at the goal, v² = 2 a · way, and no faster than the limit.
        double wanted = Math.Sign(missing) * Math.Min(fastest, Math.Sqrt(2 * SidewaysAcceleration * Math.Abs(missing)));
        _sideways += Math.Clamp(wanted - _sideways, -SidewaysAcceleration * seconds, SidewaysAcceleration * seconds);
        _sideways = Math.Clamp(_sideways, -fastest, fastest);
        Offset += _sideways * seconds;
    }
}
