namespace Harvester.Sessions.Plans;

/// <summary>The trials of a plan, in their order.</summary>
public static class TrialList
{
    /// <summary>
    /// Every combination of place, weather, hour, camera and repetition. The repetition changes fastest, the place slowest, each in the
    /// order of the plan.
    /// </summary>
    /// <param name="plan">The plan.</param>
    /// <param name="places">Its places, chosen.</param>
    public static IReadOnlyList<Trial> Of(Plan plan, IReadOnlyList<PlanPlace> places)
    {
        _ = plan ?? throw new ArgumentNullException(nameof(plan));
        return
        [
            .. from place in places
            from weather in plan.Weathers
            from hour in plan.Hours
            from camera in plan.Cameras
            from repetition in Enumerable.Range(1, plan.Repetitions)
            select new Trial(place, weather, hour, camera, repetition),
        ];
    }
}
