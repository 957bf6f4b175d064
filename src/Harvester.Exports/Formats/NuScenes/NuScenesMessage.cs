namespace Harvester.Exports.Formats.NuScenes;

/// <summary>A message of the CAN bus.</summary>
/// <param name="Timestamp">Time, microseconds.</param>
/// <param name="Fields">Its fields in order; null for a number that is unknown.</param>
internal sealed record NuScenesMessage(long Timestamp, IReadOnlyList<(string Name, double?[] Values)> Fields)
{
    /// <summary>The numbers of a field.</summary>
    public double?[] Of(string name) => Fields.First(field => field.Name == name).Values;
}
