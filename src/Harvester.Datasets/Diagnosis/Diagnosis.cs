using System.Collections.Generic;

namespace Harvester.Datasets.Diagnosis;

/// <summary>What logs, or a session, tell of problems.</summary>
/// <param name="Logs">The logs that were read; none for a session.</param>
/// <param name="Findings">The problems, the likeliest cause of trouble first; empty when there are none.</param>
public sealed record Diagnosis(IReadOnlyList<LogFile> Logs, IReadOnlyList<Finding> Findings);
