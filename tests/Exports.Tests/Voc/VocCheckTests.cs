using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Voc;

public sealed class VocCheckTests(SimulatedSession simulated) : CheckTests(simulated, "voc")
{
    private const string Annotation = "Annotations/00000001.xml";

    [Theory]
    [InlineData("<filename>.*<", "<filename>x.png<", 3, "filename is not '00000001.png'.")]
    [InlineData("<width>200<", "<width>300<", 7, "its size is not that of the image, 200 x 150.")]
    [InlineData("<name>.*<", "<name>lorry<", 13, "'lorry' is not a class of the export.")]
    [InlineData("<truncated>.*<", "<truncated>2<", 13, "truncated is not 0 or 1.")]
    [InlineData("<difficult>.*<", "<difficult>yes<", 13, "difficult is not 0 or 1.")]
    [InlineData("<xmin>.*<", "<xmin>0<", 19, "its box does not lie in the image.")]
    [InlineData("<ymax>.*<", "<ymax>151<", 19, "its box does not lie in the image.")]
    [InlineData("<ymin>.*<", "<ymin>150<", 19, "its box does not lie in the image.")]
    [InlineData("</bndbox>", "</box>", 24, "it is not valid XML from here on.")]
    public void A_damaged_annotation_is_found_with_its_line(string pattern, string replacement, int line, string expected) =>
        AssertDamageIsFound(Annotation, pattern, replacement, $"{Annotation}, line {line}: {expected}");

    [Theory]
    [InlineData(Annotation, Annotation + ": it is missing, but its image exists.")]
    [InlineData("JPEGImages/00000001.png", Annotation + ": its image is missing.")]
    [InlineData("JPEGImages/00000001.png", "ImageSets/Main/train.txt, line 2: '00000001' is not in the dataset.")]
    [InlineData("ImageSets/Main/train.txt", "ImageSets/Main/*.txt: '00000000' is not in any list.")]
    [InlineData("labelmap.txt", "labelmap.txt: the class 'car' is missing.")]
    public void Missing_file_is_found(string file, string expected) => AssertLossIsFound(file, expected);
}
