namespace Harvester.Sessions.Plans;

/// <summary>One trial of a plan: one drive under one set of conditions, which becomes one session.</summary>
/// <param name="Place">Where it begins; chosen.</param>
/// <param name="Weather">Name of the weather.</param>
/// <param name="Hour">Time of day at its start.</param>
/// <param name="Camera">Its camera or rig.</param>
/// <param name="Repetition">Its number among the trials that differ in nothing else, from 1.</param>
public sealed record Trial(PlanPlace Place, string Weather, TimeSpan Hour, PlanCamera Camera, int Repetition)
{
    private const uint FnvOffset = 2_166_136_261;
    private const uint FnvPrime = 16_777_619;

    /// <summary>
    /// The name of the trial, also of its folder: place, weather, hour, camera and repetition. It stays the same if others are added to the
    /// plan.
    /// </summary>
    public string Id =>
        FormattableString.Invariant($"{Place.Name}_{Weather}_{Hour.Hours:00}{Hour.Minutes:00}_{Camera.Name}_{Repetition:000}");

    /// <summary>
    /// Random seed of an attempt at this trial, 0 or more: FNV-1a, 32 bits, of the text SEED/ID, or SEED/ID/ATTEMPT from the second attempt
    /// on, without the highest bit.
    /// </summary>
    /// <param name="planSeed">Seed of the plan.</param>
    /// <param name="attempt">Number of the attempt, from 1.</param>
    public int SeedOf(int planSeed, int attempt)
    {
        string text = FormattableString.Invariant($"{planSeed}/{Id}") + (attempt > 1 ? FormattableString.Invariant($"/{attempt}") : "");
        uint hash = FnvOffset;
        foreach (char letter in text)
        {
            hash = unchecked((hash ^ letter) * FnvPrime);
        }

        return (int)(hash & int.MaxValue);
    }
}
