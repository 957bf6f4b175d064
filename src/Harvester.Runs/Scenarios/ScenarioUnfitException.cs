using Harvester.Runs.Faults;

namespace Harvester.Runs.Scenarios;

/// <summary>A scenario cannot happen at a place, or anywhere on the roads; the message says why.</summary>
/// <param name="message">Why, in sentences.</param>
public sealed class ScenarioUnfitException(string message) : UsageException(message);
