using Harvester.Geometry.Cameras;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Images;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.Coco;

/// <summary>Checks the lists of images and categories, which all COCO files have, and keeps their content.</summary>
/// <param name="dataset">The dataset.</param>
internal sealed class CocoImages(DatasetContent dataset)
{
    private readonly Dictionary<long, ImageSize> _sizes = [];
    private readonly HashSet<int> _categories = [];
    private readonly HashSet<string> _namesOfAll = new(StringComparer.Ordinal);
    private readonly HashSet<long> _idsOfAll = [];

    /// <summary>Sizes of the images in the file read last, by id.</summary>
    public IReadOnlyDictionary<long, ImageSize> Sizes => _sizes;

    /// <summary>Whether the file read last has a category.</summary>
    public bool HasCategory(int category) => _categories.Contains(category);

    /// <summary>Reads the file of a split; ids and names of images must differ from those of files read before.</summary>
    public IEnumerable<SessionProblem> Read(string name, string split)
    {
        _sizes.Clear();
        _categories.Clear();
        if (!dataset.Has(name))
        {
            return [new SessionProblem(name, null, "it is missing.")];
        }

        var listed = new HashSet<string>(StringComparer.Ordinal);
        SessionProblem[] problems =
        [
            .. CocoElements
                .Problems(
                    dataset,
                    name,
                    (list, element) =>
                        list switch
                        {
                            "images" => ImageProblem(element, split, listed),
                            "categories" => _categories.Add(element.Integer("id")) && element.Text("name").Length > 0
                                ? null
                                : "its category occurs twice or has no name.",
                            _ => null,
                        }
                )
                .Take(ProblemList.MaxProblems + 1),
        ];
        return problems.Concat(
            dataset
                .Files($"images/{split}")
                .Where(image => !listed.Contains(image))
                .Select(image => new SessionProblem(image, null, $"it is not listed in {name}."))
        );
    }

    private string? ImageProblem(JsonFields image, string split, HashSet<string> listed)
    {
        long id = image.LongInteger("id");
        string file = image.Text("file_name");
        ImageSize size = image.Checked(() => new ImageSize(image.Integer("width"), image.Integer("height")));
        _sizes[id] = size;
        dataset.Found(split);
        listed.Add($"images/{split}/{file}");
        ImageHeader? header = dataset.Header($"images/{split}/{file}");
        return !dataset.Has($"images/{split}/{file}") ? $"image '{file}' is not in images/{split}."
            : !_idsOfAll.Add(id) ? $"image {id} occurs twice, here or in another split."
            : !_namesOfAll.Add(file) ? $"image '{file}' occurs twice, here or in another split."
            : header is not null && header.Size != size
                ? $"image '{file}' is {header.Size.Width} x {header.Size.Height}, not {size.Width} x {size.Height}."
            : null;
    }
}
