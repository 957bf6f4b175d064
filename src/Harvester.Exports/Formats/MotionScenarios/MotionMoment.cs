using Harvester.Datasets.Logs;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>What one frame adds to scenarios.</summary>
/// <param name="Seconds">Time since the first frame of its place.</param>
/// <param name="Actors">What moves.</param>
/// <param name="Lights">What lights in the image tell lanes, by the names of these.</param>
/// <param name="Features">The map around it; empty for most frames.</param>
internal sealed record MotionMoment(
    double Seconds,
    IReadOnlyList<MotionActor> Actors,
    IReadOnlyDictionary<string, LogLight> Lights,
    IReadOnlyList<NamedFeature> Features
);
