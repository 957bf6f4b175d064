using Harvester.Geometry;

namespace Harvester.Play.Plans;

/// <summary>Finds out when an attempt at a trial has failed.</summary>
public sealed class MishapWatch
{
    /// <summary>A vehicle that has moved less than <see cref="StuckMetres"/> for so long is stuck, seconds of the game's time.</summary>
    public const double StuckSeconds = 60;

    /// <summary>Least distance of a vehicle that is not stuck, metres.</summary>
    public const double StuckMetres = 5;

    private Vector3D? _place;
    private double _since;

    /// <summary>The mishap at a moment; null without one.</summary>
    /// <param name="now">The situation.</param>
    /// <param name="gameSeconds">The game's time, seconds; it stands still while the game is frozen.</param>
    public Mishap? Check(GameSituation now, double gameSeconds)
    {
        if (_place is not { } place || (now.Position - place).Length >= StuckMetres)
        {
            (_place, _since) = (now.Position, gameSeconds);
        }

        return now switch
        {
            { IsDead: true } => Mishap.Dead,
            { IsInCutScene: true } => Mishap.CutScene,
            { IsSwitching: true } => Mishap.PlayerSwitch,
            { IsInVehicle: false } => Mishap.OnFoot,
            { IsInWater: true } => Mishap.InWater,
            { IsUpsideDown: true } => Mishap.UpsideDown,
            { WantedLevel: > 0 } => Mishap.Wanted,
            _ => gameSeconds - _since > StuckSeconds ? Mishap.Stuck : null,
        };
    }

    /// <summary>A mishap in words.</summary>
    public static string TextOf(Mishap mishap) =>
        mishap switch
        {
            Mishap.Dead => "The player died.",
            Mishap.CutScene => "A cut scene began.",
            Mishap.PlayerSwitch => "The game changed to another character.",
            Mishap.Wanted => "The player was wanted.",
            Mishap.OnFoot => "The player left the vehicle.",
            Mishap.InWater => "The vehicle was in water.",
            Mishap.UpsideDown => "The vehicle lay on its roof.",
            Mishap.Stuck => FormattableString.Invariant($"The vehicle was stuck: it moved less than {StuckMetres} m in {StuckSeconds} s."),
            Mishap.OffPath => "The vehicle left its path.",
            _ => throw new ArgumentOutOfRangeException(nameof(mishap), mishap, "Not a mishap."),
        };
}
