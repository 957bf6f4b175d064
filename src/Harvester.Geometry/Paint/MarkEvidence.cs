namespace Harvester.Geometry.Paint;

/// <summary>What images show of the stop lines and crossings in the mouths of junctions.</summary>
internal sealed class MarkEvidence
{
    /// <summary>Images of a mouth that are kept, as of a row: enough for a median.</summary>
    private const int MaxImages = 32;

    private readonly SortedDictionary<int, (List<MouthView> Views, List<SeenMark> Marks)> _mouths = [];

    /// <summary>The mouths that were seen, by their index.</summary>
    public IEnumerable<KeyValuePair<int, (List<MouthView> Views, List<SeenMark> Marks)>> Mouths => _mouths;

    /// <summary>Adds what an image shows of a mouth.</summary>
    public void Add(int mouth, MouthView view, IEnumerable<SeenMark> marks)
    {
        (List<MouthView> views, List<SeenMark> found) = MouthFor(mouth);
        if (views.Count < MaxImages)
        {
            views.Add(view);
            found.AddRange(marks);
        }
    }

    /// <summary>Adds what other images show; of a mouth that was seen in many images, the first ones are kept.</summary>
    public void Add(MarkEvidence other)
    {
        foreach (KeyValuePair<int, (List<MouthView> Views, List<SeenMark> Marks)> mouth in other._mouths)
        {
            foreach (MouthView view in mouth.Value.Views)
            {
                Add(mouth.Key, view, mouth.Value.Marks.Where(mark => mark.Image == view.Image));
            }
        }
    }

    private (List<MouthView> Views, List<SeenMark> Marks) MouthFor(int mouth)
    {
        if (!_mouths.TryGetValue(mouth, out (List<MouthView>, List<SeenMark>) found))
        {
            _mouths.Add(mouth, found = ([], []));
        }

        return found;
    }
}
