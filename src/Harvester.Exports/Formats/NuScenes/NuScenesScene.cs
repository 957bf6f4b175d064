namespace Harvester.Exports.Formats.NuScenes;

/// <summary>A scene: the moments of a session at one place.</summary>
/// <param name="Number">Its number in the dataset, from 0.</param>
/// <param name="Frames">Its frames, in their order.</param>
internal sealed record NuScenesScene(int Number, IReadOnlyList<NuScenesPart> Frames)
{
    /// <summary>
    /// Scenes of the official dataset end at 1110. Numbers above it cannot be taken for theirs by a reader that knows official splits.
    /// </summary>
    private const int FirstNumber = 2001;

    private ILookup<int, NuScenesPart>? _byMoment;
    private int[]? _keys;
    private NuScenesArea? _area;

    /// <summary>Its session.</summary>
    public int Recording => Frames[0].Recording;

    /// <summary>Its name: four digits, as the CAN bus reader of the devkit expects them.</summary>
    public string Name => NameOf(Number);

    /// <summary>The name of a scene.</summary>
    public static string NameOf(int number) => $"scene-{Numbers.Text(FirstNumber + number)}";

    /// <summary>Its token.</summary>
    public string Token => NuScenesToken.Of("scene", Number);

    /// <summary>The token of its log: each scene has one, because its global frame and its map are its own.</summary>
    public string LogToken => NuScenesToken.Of("log", Number);

    /// <summary>What its map shows. The lower left corner is the origin of its global frame.</summary>
    public NuScenesArea Area => _area ??= NuScenesArea.Of(Frames.Select(frame => frame.Area));

    /// <summary>Its moments that are samples, in order.</summary>
    public IReadOnlyList<int> Keys => KeyMoments;

    private int[] KeyMoments => _keys ??= [.. Frames.Where(frame => frame.IsKey).Select(frame => frame.Moment).Distinct().Order()];

    /// <summary>The frames of a moment.</summary>
    public IEnumerable<NuScenesPart> Of(int moment) => (_byMoment ??= Frames.ToLookup(frame => frame.Moment))[moment];

    /// <summary>The events that are open at a moment; null in a session without events.</summary>
    public IReadOnlyList<NuScenesEvent>? EventsOf(int moment) => Of(moment).First().Events;

    /// <summary>The token of a sample.</summary>
    public string SampleTokenOf(int moment) => NuScenesToken.Of("sample", Number, moment);

    /// <summary>The sample to which the data of a moment belong: the next one, or the last if none follows.</summary>
    public int SampleOf(int moment)
    {
        int found = Array.BinarySearch(KeyMoments, moment);
        return KeyMoments[Math.Min(found < 0 ? ~found : found, KeyMoments.Length - 1)];
    }

    /// <summary>The token of an instance.</summary>
    public string InstanceTokenOf(int id) => NuScenesToken.Of("instance", Number, id);

    /// <summary>The token of an annotation.</summary>
    public string AnnotationTokenOf(int id, int moment) => NuScenesToken.Of("sample_annotation", Number, moment, id);

    /// <summary>The token of a calibrated sensor.</summary>
    public string CalibrationTokenOf(string channel) => NuScenesToken.Of("calibrated_sensor", Recording, channel);

    /// <summary>The token of the data of a sensor.</summary>
    public string DataTokenOf(string channel, int moment) => NuScenesToken.Of("sample_data", Number, moment, channel);

    /// <summary>The token of the pose of the data of a sensor.</summary>
    public string PoseTokenOf(string channel, int moment) => NuScenesToken.Of("ego_pose", Number, moment, channel);

    /// <summary>The annotated objects of each sample, those of all views once, by ascending id.</summary>
    public IEnumerable<(int Moment, IReadOnlyList<NuScenesSighting> Objects)> Annotated() =>
        Keys.Select(moment =>
        {
            NuScenesPart[] views = [.. Of(moment)];
            return (
                moment,
                (IReadOnlyList<NuScenesSighting>)
                    [
                        .. views
                            .SelectMany(view => view.Objects)
                            .GroupBy(item => item.Id)
                            .OrderBy(group => group.Key)
                            .Select(NuScenesSighting.Of),
                    ]
            );
        });

    /// <summary>The scenes of parts, which come session by session and place by place; a place without a sample is left out.</summary>
    public static IEnumerable<NuScenesScene> All(IEnumerable<string> lines) =>
        Divided(lines).Where(frames => frames.Exists(frame => frame.IsKey)).Select((frames, number) => new NuScenesScene(number, frames));

    private static IEnumerable<List<NuScenesPart>> Divided(IEnumerable<string> lines)
    {
        var frames = new List<NuScenesPart>();
        foreach (NuScenesPart frame in lines.Select(NuScenesPart.Read))
        {
            if (frames.Count > 0 && (frames[0].Recording != frame.Recording || frames[0].Place != frame.Place))
            {
                yield return frames;
                frames = [];
            }

            frames.Add(frame);
        }

        if (frames.Count > 0)
        {
            yield return frames;
        }
    }
}
