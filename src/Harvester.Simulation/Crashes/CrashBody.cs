using Harvester.Geometry;

namespace Harvester.Simulation.Crashes;

/// <summary>A body that takes part in crashes for one step of the world.</summary>
/// <param name="handle">Handle of its entity.</param>
/// <param name="body">Its state at the beginning of the step; moved by the step.</param>
/// <param name="height">Metres, world z; bodies on different levels of a bridge do not touch.</param>
/// <param name="slideDeceleration">Deceleration when it slides, m/s².</param>
internal sealed class CrashBody(int handle, PlanarBody body, double height, double slideDeceleration)
{
    private const double SameLevel = 3.5;

    public int Handle { get; } = handle;

    public PlanarBody Body { get; } = body;

    public double Height { get; } = height;

    public double SlideDeceleration { get; } = slideDeceleration;

    /// <summary>Where its driver steers it in this step; null for a body that nobody drives.</summary>
    public DrivenWay? Way { get; set; }

    /// <summary>Whether it was struck in this step.</summary>
    public bool IsStruck { get; private set; }

    public bool MayTouch(CrashBody other) => Math.Abs(Height - other.Height) < SameLevel;

    /// <summary>Moves it by a part of the step.</summary>
    /// <param name="from">Share of the step that has passed.</param>
    /// <param name="to">Share of the step that will then have passed.</param>
    /// <param name="seconds">Length of the whole step.</param>
    public void Move(double from, double to, double seconds)
    {
        if (Way is { } way)
        {
            Body.Position = way.PositionAt(to);
            Body.Yaw = way.YawAt(to);
            return;
        }

        // Midpoint rule: under constant friction the mean of the velocities before and after gives the exact way.
        Vector2D velocity = Body.Velocity;
        double yawRate = Body.YawRate;
        double part = (to - from) * seconds;
        TyreSlide.Slow(Body, SlideDeceleration, part);
        Body.Position += (velocity + Body.Velocity) * (part / 2);
        Body.Yaw += (yawRate + Body.YawRate) * (part / 2);
    }

    /// <summary>Changes its motion by an impulse; from now on nobody drives it.</summary>
    public void Strike(Vector2D impulse, Vector2D place)
    {
        IsStruck = true;
        Way = null;
        Body.Push(impulse, place);
    }
}
