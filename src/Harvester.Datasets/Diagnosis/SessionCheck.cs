using System.Collections.Generic;
using System.Linq;
using Harvester.Datasets.Sessions;

namespace Harvester.Datasets.Diagnosis;

/// <summary>What session.json tells of problems.</summary>
internal static class SessionCheck
{
    /// <summary>Looks at a session that was opened.</summary>
    public static IEnumerable<Finding> Of(SessionInfo session)
    {
        LogLine Evidence(string text) => new(SessionInfo.FileName, null, text);
        if (session.CapturedFrames is not { } captured)
        {
            yield return new Finding(
                "The session was cut off, or is still being recorded.",
                "What was written is valid: go on with it as with any other.",
                Evidence("state is recording"));
            yield break;
        }

        if (session.Fault is { } fault)
        {
            LogLine[] told = [Evidence(fault)];
            Finding[] known = [.. LineRule.Apply(ModRules.All, told)];
            Finding unknown = new("The harvest was ended by a failure.", "The log of that run says more. If it happens again, report it with the log.", told[0]);
            foreach (Finding finding in known.DefaultIfEmpty(unknown))
            {
                yield return finding;
            }
        }

        string counts = $"{captured} captured, discarded: {string.Join(", ", session.Discards.Select(discard => $"{discard.Value} {discard.Key}"))}";
        foreach (Finding finding in DiscardCheck.Of(captured, session.Discards, session.IsFreezeGiven, Evidence(counts)))
        {
            yield return finding;
        }
    }
}
