namespace Harvester.Play.Screen;

/// <summary>Finds a process's main window on the desktop, and decides whether a copy of the screen would show it completely.</summary>
internal static class WindowJudge
{
    /// <summary>Finds the window and decides.</summary>
    /// <param name="view">The desktop.</param>
    /// <param name="processId">The game's process.</param>
    /// <param name="known">The window found before; 0 at first. It stays the game's window as long as it is shown.</param>
    public static WindowVerdict Judge(DesktopView view, int processId, long known)
    {
        TopLevelWindow? window = Find(view, processId, known);
        string? refusal = window is null ? GrabRefusals.NoWindow : RefusalOf(window, view);
        return new WindowVerdict(window?.Handle ?? 0, window?.Client ?? default, refusal);
    }

    /// <summary>
    /// The window found before, as long as it is shown; otherwise the largest application window of the process; null if there is none.
    /// </summary>
    public static TopLevelWindow? Find(DesktopView view, int processId, long known)
    {
        IEnumerable<TopLevelWindow> own = view.Windows.Where(window => window.ProcessId == processId);
        return own.FirstOrDefault(window => window.Handle == known)
            ?? own.Where(window => window.IsApplication).OrderByDescending(window => window.RestoredArea).FirstOrDefault();
    }

    private static string? RefusalOf(TopLevelWindow window, DesktopView view)
    {
        if (window.IsMinimised)
        {
            return GrabRefusals.Minimised;
        }

        if (window.Client.IsEmpty || window.ShowsNothing)
        {
            return GrabRefusals.NoWindow;
        }

        if (!IsCoveredBy(view.Monitors, 0, window.Client))
        {
            return GrabRefusals.OffScreen;
        }

        bool covered = view
            .Windows.TakeWhile(above => above.Handle != window.Handle)
            .Any(above => !above.IsMinimised && !above.ShowsNothing && above.Bounds.Overlaps(window.Client));
        return covered ? GrabRefusals.Covered : null;
    }

    /// <summary>Whether the rectangles from <paramref name="next"/> on cover an area completely.</summary>
    private static bool IsCoveredBy(IReadOnlyList<DesktopRectangle> rectangles, int next, DesktopRectangle area)
    {
        if (area.IsEmpty)
        {
            return true;
        }

        if (next == rectangles.Count)
        {
            return false;
        }

        DesktopRectangle shared = area.Intersect(rectangles[next]);
        next++;
        return shared.IsEmpty
            ? IsCoveredBy(rectangles, next, area)
            : IsCoveredBy(rectangles, next, area with { Bottom = shared.Top })
                && IsCoveredBy(rectangles, next, area with { Top = shared.Bottom })
                && IsCoveredBy(rectangles, next, shared with { Left = area.Left, Right = shared.Left })
                && IsCoveredBy(rectangles, next, shared with { Left = shared.Right, Right = area.Right });
    }
}
