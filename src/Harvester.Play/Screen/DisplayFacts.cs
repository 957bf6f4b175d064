namespace Harvester.Play.Screen;

/// <summary>How a window is displayed.</summary>
/// <param name="Dpi">Dots per inch of its monitor, 96 for a scaling of 100 %; null if Windows does not report it.</param>
/// <param name="IsExclusive">Whether a program runs in exclusive full screen.</param>
internal readonly record struct DisplayFacts(int? Dpi, bool IsExclusive)
{
    /// <summary>Whether a monitor shows HDR; null if Windows does not report it.</summary>
    public bool? IsHdr { get; init; }
}
