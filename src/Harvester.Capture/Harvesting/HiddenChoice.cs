using System.Globalization;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Which objects of a moment a further picture does not show: all of some classes, the nearest of them, or one by its id.
/// </summary>
public sealed class HiddenChoice
{
    /// <summary>The form of a choice, for messages.</summary>
    public const string Form =
        "signs, vehicles, people, a class, each also as nearest-sign, nearest-vehicle, nearest-person or nearest-CLASS, or an object's id";

    private const string Nearest = "nearest-";

    private static readonly Dictionary<string, ObjectClass[]> Groups = new(StringComparer.Ordinal)
    {
        ["sign"] = [ObjectClass.Sign],
        ["vehicle"] =
        [
            ObjectClass.Car,
            ObjectClass.Truck,
            ObjectClass.Bus,
            ObjectClass.Motorcycle,
            ObjectClass.Bicycle,
            ObjectClass.Trailer,
        ],
        ["person"] = [ObjectClass.Pedestrian],
    };

    private readonly IReadOnlyList<ObjectClass> _classes;
    private readonly bool _isNearest;
    private readonly int? _id;

    private HiddenChoice(string name, IReadOnlyList<ObjectClass> classes, bool isNearest, int? id) =>
        (Name, _classes, _isNearest, _id) = (name, classes, isNearest, id);

    /// <summary>Its name, as it was given.</summary>
    public string Name { get; }

    /// <summary>Reads a choice; null if the text is not one.</summary>
    /// <param name="text">As <see cref="Form"/> says.</param>
    public static HiddenChoice? Parse(string text)
    {
        if (text is null)
        {
            throw new ArgumentNullException(nameof(text));
        }

        if (int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int id))
        {
            return id is > 0 and <= ushort.MaxValue ? new HiddenChoice(id.ToString(CultureInfo.InvariantCulture), [], false, id) : null;
        }

        bool isNearest = text.StartsWith(Nearest, StringComparison.Ordinal);
        string kind = isNearest
            ? text.Substring(Nearest.Length)
            : text switch
            {
                "signs" => "sign",
                "vehicles" => "vehicle",
                "people" => "person",
                _ => text,
            };
        ObjectClass[] classes = Groups.TryGetValue(kind, out ObjectClass[]? group)
            ? group
            : [.. typeof(ObjectClass).GetEnumValues().Cast<ObjectClass>().Where(each => JsonName.Of(each) == kind)];
        return classes.Length == 0 ? null : new HiddenChoice(text, classes, isNearest, null);
    }

    /// <summary>The entities to hide.</summary>
    /// <param name="objects">The labels of each entity, which are its own and those of its parts, by its handle.</param>
    internal IReadOnlyList<IGrouping<int, ObjectLabel>> Of(IEnumerable<IGrouping<int, ObjectLabel>> objects)
    {
        IEnumerable<IGrouping<int, ObjectLabel>> chosen = objects.Where(entity => entity.Any(IsMeant));
        return _isNearest
            ? [.. chosen.OrderBy(entity => entity.Where(IsMeant).Min(label => label.DistanceMetres)).ThenBy(entity => entity.Key).Take(1)]
            : [.. chosen];
    }

    private bool IsMeant(ObjectLabel label) => _id is { } id ? label.Id == id : _classes.Contains(label.Class);
}
