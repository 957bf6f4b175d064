namespace Harvester.Exports.Formats.NuScenes;

/// <summary>An object at a sample, as all its views show it together.</summary>
/// <param name="Object">What all views agree on.</param>
/// <param name="VisibleFraction">The part of its boxes in all images that nothing hides, 0 to 1.</param>
internal sealed record NuScenesSighting(NuScenesObject Object, double VisibleFraction)
{
    /// <summary>Whether it moves.</summary>
    public bool IsMoving => MovingObjects.IsMoving(Object.Speed);

    /// <summary>Puts together what the views show.</summary>
    public static NuScenesSighting Of(IEnumerable<NuScenesObject> views)
    {
        NuScenesObject[] all = [.. views];
        double area = all.Sum(view => view.Area);
        return new NuScenesSighting(all[0], area > 0 ? all.Sum(view => view.VisibleArea) / area : 0);
    }
}
