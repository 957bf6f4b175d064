namespace Harvester.Sessions.Labels;

/// <summary>What the channels of a frame say in its label, at most one of each type. It does not change.</summary>
public sealed class ChannelLabels
{
    private readonly IReadOnlyList<IChannelLabel> _labels;

    private ChannelLabels(IReadOnlyList<IChannelLabel> labels) => _labels = labels;

    /// <summary>No channel.</summary>
    public static ChannelLabels None { get; } = new([]);

    /// <summary>Paths within the session of the files of all channels, in the order of <see cref="FrameChannels.All"/>.</summary>
    public IEnumerable<string> Files => FrameChannels.All.SelectMany(channel => channel.LabelIn(this)?.Files ?? []);

    /// <summary>What one channel says; null if the frame does not have it.</summary>
    public T? Get<T>()
        where T : class, IChannelLabel => _labels.OfType<T>().FirstOrDefault();

    /// <summary>What the first channel of a type says for which a condition holds; null if there is none.</summary>
    internal T? Get<T>(Func<T, bool> isIt)
        where T : class, IChannelLabel => _labels.OfType<T>().FirstOrDefault(isIt);

    /// <summary>These with another of the same channel, or with one more.</summary>
    /// <param name="label">What the channel says; null to leave it out.</param>
    public ChannelLabels With<T>(T? label)
        where T : class, IChannelLabel
    {
        IEnumerable<IChannelLabel> others = _labels.Where(static each => each is not T);
        return new([.. label is null ? others : others.Append(label)]);
    }

    /// <summary>These, and what a further channel says.</summary>
    public ChannelLabels And(IChannelLabel label) => new([.. _labels, label ?? throw new ArgumentNullException(nameof(label))]);

    /// <summary>Those that still hold when labels are recomputed with another lens.</summary>
    public ChannelLabels WithoutLens() =>
        new([
            .. FrameChannels
                .All.Select(channel => channel.LabelIn(this) is { } label && channel.OutlivesLens(label) ? label : null)
                .OfType<IChannelLabel>(),
        ]);
}
