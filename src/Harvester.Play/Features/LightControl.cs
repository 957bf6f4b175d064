using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Play.Settings;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Features;

/// <summary>
/// Drives the traffic lights around the camera during a harvest, so that their state is known, and gives them back to the game after it.
/// The lights of crossing roads take turns. It uses the game's time: while the game is frozen, no light changes.
/// </summary>
public sealed class LightControl : IFeature, ILights
{
    private const int GamesOwn = 3;
    private const double GreenSeconds = 7;
    private const double AmberSeconds = 2;
    private const double PhaseSeconds = GreenSeconds + AmberSeconds + 1;
    private const double LookEverySeconds = 1;
    private readonly IWorld _world;
    private readonly ITrafficLights _lights;
    private readonly LightOrder _order;
    private readonly double _rangeMetres;
    private readonly int _settlingFrames;
    private readonly Dictionary<int, Driven> _driven = [];
    private double _lookedAt = double.NegativeInfinity;

    /// <summary>Creates the feature; it is off.</summary>
    /// <param name="world">The game's world.</param>
    /// <param name="lights">The game's lights.</param>
    /// <param name="order">The meaning of the game's numbers.</param>
    /// <param name="rangeMetres">Maximum distance from the camera of the lights that are driven, metres.</param>
    /// <param name="settlingFrames">Maximum number of frames by which the picture may lag behind the game; for that long after a change the
    /// visible state is unknown.</param>
    public LightControl(IWorld world, ITrafficLights lights, LightOrder order, double rangeMetres, int settlingFrames)
    {
        _world = world;
        _lights = lights;
        _order = order;
        _rangeMetres = rangeMetres;
        _settlingFrames = settlingFrames;
    }

    /// <inheritdoc/>
    public string Name => "The driving of traffic lights";

    /// <inheritdoc/>
    public bool IsOn => IsWanted();

    /// <summary>Whether lights are to be driven.</summary>
    public Func<bool> IsWanted { get; init; } = static () => false;

    /// <inheritdoc/>
    public LightState? SetStateOf(int entity, long gameFrame) =>
        _driven.TryGetValue(entity, out Driven light) && gameFrame >= light.SinceFrame + _settlingFrames ? light.State : null;

    /// <inheritdoc/>
    public void Tick()
    {
        if (!IsWanted())
        {
            Stop();
            return;
        }

        double now = _world.TimeSeconds;
        if (now - _lookedAt >= LookEverySeconds)
        {
            _lookedAt = now;
            Look();
        }

        foreach (KeyValuePair<int, Driven> light in _driven.ToArray())
        {
            LightState state = StateAt(now, light.Value.IsCrossing);
            if (state != light.Value.State && _lights.Exists(light.Key))
            {
                Set(light.Key, state, light.Value.IsCrossing);
            }
        }
    }

    /// <inheritdoc/>
    public void Stop()
    {
        _lookedAt = double.NegativeInfinity;
        GiveBack([.. _driven.Keys]);
    }

    private static LightState StateAt(double seconds, bool isCrossing)
    {
        double time = (seconds + (isCrossing ? PhaseSeconds : 0)) % (2 * PhaseSeconds);
        return time < GreenSeconds ? LightState.Green
            : time < GreenSeconds + AmberSeconds ? LightState.Amber
            : LightState.Red;
    }

    /// <summary>Takes over the lights that have come near, and gives back those that no longer are.</summary>
    private void Look()
    {
        EntityState[] near =
        [
            .. _world
                .ReadEntities(_world.ReadCamera().Pose.Position, _rangeMetres)
                .Where(entity => entity.Class == ObjectClass.TrafficLight),
        ];
        GiveBack([.. _driven.Keys.Except(near.Select(light => light.Handle))]);
        foreach (EntityState light in near.Where(light => !_driven.ContainsKey(light.Handle)))
        {
            Vector3D along = light.Pose.Axes.Forward;
            bool isCrossing = Math.Abs(along.X) > Math.Abs(along.Y);
            Set(light.Handle, StateAt(_world.TimeSeconds, isCrossing), isCrossing);
        }
    }

    private void Set(int light, LightState state, bool isCrossing)
    {
        // Recorded first, so that it is given back even if the game fails now.
        _driven[light] = new Driven(state, _world.GameFrame, isCrossing);
        _lights.Override(light, NumberOf(state));
    }

    private void GiveBack(IReadOnlyList<int> lights)
    {
        Exception? failure = null;
        foreach (int light in lights)
        {
            try
            {
                if (_lights.Exists(light))
                {
                    _lights.Override(light, GamesOwn);
                }

                _driven.Remove(light);
            }
#pragma warning disable CA1031 // One light that cannot be given back must not prevent the others.
            catch (Exception exception) when (exception is not ThreadAbortException)
#pragma warning restore CA1031
            {
                failure ??= exception;
            }
        }

        if (failure is not null)
        {
            throw new InvalidOperationException(failure.Message, failure);
        }
    }

    private int NumberOf(LightState state) =>
        (_order, state) switch
        {
            (LightOrder.GreenRedAmber, LightState.Red) => 1,
            (LightOrder.GreenRedAmber, LightState.Amber) => 2,
            (LightOrder.GreenRedAmber, _) => 0,
            (_, LightState.Red) => 0,
            (_, LightState.Amber) => 1,
            _ => 2,
        };

    private readonly record struct Driven(LightState State, long SinceFrame, bool IsCrossing);
}
