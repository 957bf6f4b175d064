using System.Collections.Generic;

namespace Harvester.Datasets.Diagnosis;

/// <summary>The problems that logs or a session show.</summary>
/// <param name="Logs">The logs that were read; empty for a session.</param>
/// <param name="Findings">The problems, the likeliest cause first; empty if there are none.</param>
public sealed record Diagnosis(IReadOnlyList<LogFile> Logs, IReadOnlyList<Finding> Findings);
