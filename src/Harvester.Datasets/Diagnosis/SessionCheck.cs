using Harvester.Sessions.Reading;

namespace Harvester.Datasets.Diagnosis;

/// <summary>Problems in session.json.</summary>
internal static class SessionCheck
{
    /// <summary>The findings for a session.</summary>
    public static IEnumerable<Finding> Of(SessionInfo session)
    {
        LogLine Evidence(string text) => new(SessionInfo.FileName, null, text);
        if (session.CapturedFrames is not { } captured)
        {
            yield return new Finding(
                "The session was cut off, or is still being recorded.",
                "What was written is valid and can be used like any other session.",
                Evidence("state is recording")
            );
            yield break;
        }

        if (session.Fault is { } fault)
        {
            LogLine line = Evidence(fault);
            Finding[] known = [.. LineRule.Apply(ModRules.All, [line])];
            Finding unknown = new(
                "The harvest ended with an error.",
                "The log of that run says more. If it happens again, report it with the log.",
                line
            );
            foreach (Finding finding in known.DefaultIfEmpty(unknown))
            {
                yield return finding;
            }
        }

        if (session.PictureWarning is { } warning)
        {
            yield return new Finding(
                "Something spoils the pictures.",
                "Run the mod's self-test, which finds the cause: switch off the display, or HDR, and harvest again.",
                Evidence(warning)
            );
        }

        if (session.DoesDisplayStay)
        {
            yield return new Finding(
                "The game's radar and HUD may be in the pictures: hiding them changed nothing while the game was frozen.",
                "Switch both off in the game's settings, and harvest again.",
                Evidence("start.display.state is stays")
            );
        }

        if (session.ColourState is "clipped" or "changed")
        {
            yield return new Finding(
                "The colours of the pictures are not those of the game: HDR, Auto HDR, a filter or a colour profile changes them.",
                "Switch these off in Windows and in the game, and harvest again.",
                Evidence($"start.colours.state is {session.ColourState}")
            );
        }

        string counts =
            $"{captured} captured, discarded: "
            + $"{string.Join(", ", session.Discards.Select(discard => $"{discard.Value} {discard.Key}"))}";
        foreach (Finding finding in DiscardCheck.Of(captured, session.Discards, session.IsFreezeGiven, Evidence(counts)))
        {
            yield return finding;
        }
    }
}
