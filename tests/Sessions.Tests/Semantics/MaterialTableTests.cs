using Harvester.Sessions.Scenes;
using Harvester.Sessions.Semantics;

namespace Harvester.Sessions.Tests.Semantics;

public sealed class MaterialTableTests
{
    private const string Header = "material,hash,class,upright\n";

    [Theory]
    // Tarmac, concrete as ground and as a wall, leaves, and a hash that no material has.
    [InlineData(0x10DD5498, 1.0, SemanticClass.Road)]
    [InlineData(0x46CA81E8, 1.0, SemanticClass.Pavement)]
    [InlineData(0x46CA81E8, 0.1, SemanticClass.Building)]
    [InlineData(0x8653C6CD, 0.1, SemanticClass.Vegetation)]
    [InlineData(0x00000001, 1.0, SemanticClass.Other)]
    public void Shipped_table_gives_classes(uint material, double normalZ, SemanticClass expected) =>
        Assert.Equal(expected, MaterialTable.BuiltIn.ClassOf(material, normalZ));

    [Fact]
    public void Unknown_normal_is_taken_as_level() => Assert.Equal(SemanticClass.Pavement, MaterialTable.BuiltIn.ClassOf(0x46CA81E8, null));

    [Fact]
    public void Own_table_is_read()
    {
        MaterialTable table = MaterialTable.Read(new StringReader("# mine\n\n" + Header + "moss, 0x0000abcd ,terrain,\n"));

        Assert.Equal(1, table.Count);
        Assert.Equal(SemanticClass.Terrain, table.ClassOf(0xABCD, 0));
    }

    [Theory]
    [InlineData("moss,0x1,terrain", "line 2: it has 3 columns")]
    [InlineData("moss,abcd,terrain,", "line 2: column hash: 'abcd'")]
    [InlineData("moss,0x123456789,terrain,", "line 2: column hash")]
    [InlineData("moss,0x1,lava,", "line 2: column class: 'lava'")]
    [InlineData("moss,0x1,terrain,lava", "line 2: column upright: 'lava'")]
    [InlineData("a,0x1,terrain,\nb,0x1,road,", "line 3: column hash: 0x1 is in the table twice")]
    public void Invalid_row_is_refused_with_its_place(string rows, string expected)
    {
        FormatException refused = Assert.Throws<FormatException>(() => MaterialTable.Read(new StringReader(Header + rows)));

        Assert.StartsWith(expected, refused.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Classes_of_objects_have_the_names_of_their_classes()
    {
        foreach (ObjectClass kind in Enum.GetValues<ObjectClass>())
        {
            SemanticClass found = SemanticClasses.Of(kind);
            Assert.Equal(kind.ToString(), found.ToString());
            Assert.Equal(kind, SemanticClasses.ObjectOf(found));
        }

        Assert.Null(SemanticClasses.ObjectOf(SemanticClass.Fence));
    }

    [Fact]
    public void Each_class_has_a_colour_of_its_own() => Assert.Distinct(Enum.GetValues<SemanticClass>().Select(SemanticClasses.ColourOf));
}
