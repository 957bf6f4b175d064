namespace Harvester.Simulation.People;

/// <summary>All postures in which a person is drawn, by number: the phases of a stride, then standing, then sitting.</summary>
internal static class PersonPoses
{
    /// <summary>Phases of a stride: one lasts about 0.04 s, less than the picture of a frame every 0.1 s could show.</summary>
    public const int Phases = 24;

    /// <summary>Number of the first posture of those who stand.</summary>
    public const int FirstStanding = Phases;

    /// <summary>Postures of those who stand.</summary>
    public const int StandingCount = 4;

    /// <summary>Number of the first posture of those who sit.</summary>
    public const int FirstSitting = FirstStanding + StandingCount;

    /// <summary>Postures of those who sit.</summary>
    public const int SittingCount = 2;

    /// <summary>The postures of a person, in their order.</summary>
    public static IReadOnlyList<BodyPose> Of(Person person)
    {
        Proportions sizes = new(person.Height, person.Shoulders);
        Gait gait = new(sizes, person.Pace);
        Poser poser = new(sizes);
        return
        [
            .. Enumerable
                .Range(0, Phases)
                .Select(phase => gait.At((double)phase / Phases))
                .Concat(Rest.Standing(sizes))
                .Concat(Rest.Sitting(sizes))
                .Select(poser.Pose),
        ];
    }
}
